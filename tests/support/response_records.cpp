#include "support/response_records.hpp"

#include <random>

namespace percuss::test {

acquire::Record response_record(double fs_Hz, std::vector<std::vector<std::vector<double>>> accel, double noise,
                                bool continuous) {
  std::mt19937 random(5);
  std::normal_distribution<double> gauss;
  std::vector<std::vector<double>> force;
  for (auto& row : accel) {
    force.emplace_back(row.front().size());
    for (auto& channel : row) {
      for (double& value : channel) value += noise * gauss(random);
    }
  }
  acquire::Record record = acquire::record_in_memory(fs_Hz, std::move(force), std::move(accel));
  record.has_force = false;
  record.continuous = continuous;
  return record;
}

}  // namespace percuss::test
