#include "metrics/protocol/session.hpp"

namespace percuss::metrics {

std::string session_example() {
  return R"({
  "schema": "percuss/session/1",
  // The metric, besr, ncaa_besr or bbcor, and its limit, which the bat must not exceed.
  "metric": "ncaa_besr",
  "limit": 0.728,
  "bat": {"id": "AS001", "length_in": 33, "weight_oz": 30.1, "moi_oz_in2": 9600, "days_in_lab": 3},
  "lab": {"temperature_f": 72.4, "humidity_percent": 51},
  // Either the lot's correction, or "hits": shots at the standard bat, written like the shots below but without z_in.
  "ball_lot": {"id": "L12", "days_in_lab": 21, "correction": 0.002},
  "gate_spacing_in": 6,
  "range_in": [3, 9],
  "shots": [
    // Give speeds as v_in_mph and v_out_mph, as the speeds of the three gate pairs, or as the times at the gates.
    {"z_in": 6, "ball": "L12-001", "ear": 1, "ball_g": 145.3, "v_in_mph": 136.2, "v_out_mph": 29.9, "angle_deg": 1.2},
    {"z_in": 6, "ball": "L12-002", "ear": 1, "ball_g": 145.6, "angle_deg": -2.0,
     "pairs_in_mph": [136.4, 136.1, 135.8], "pairs_out_mph": [30.3, 30.0, 29.8]},
    {"z_in": 6, "ball": "L12-003", "ear": 1, "ball_g": 145.1, "angle_deg": 0.4,
     "gates_in_s": [0.0, 0.002506, 0.004, 0.006507, 0.008, 0.010509],
     "gates_out_s": [0.02, 0.0314, 0.034, 0.04541, 0.048, 0.05943]}
  ]
}
)";
}

std::string session_table_example() {
  return R"(# metric = ncaa_besr
# limit = 0.728
# bat.id = AS001
# bat.length_in = 33
# bat.moi_oz_in2 = 9600
# bat.days_in_lab = 3
# lab.temperature_f = 72.4
# lab.humidity_percent = 51
# ball_lot.days_in_lab = 21
# ball_lot.correction = 0.002
z_in,ball,ear,ball_g,v_in_mph,v_out_mph,angle_deg
6,L12-001,1,145.3,136.2,29.9,1.2
6,L12-002,1,145.6,136.1,30.0,-2.0
)";
}

}  // namespace percuss::metrics
