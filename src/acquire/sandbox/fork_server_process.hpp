#pragma once
#include "acquire/sandbox/fork_server.hpp"

namespace percuss {

/// The nursery's side of a ReaderNursery: forks readers and buries them, until nobody holds the socket's other end.
void serve_nursery(int own, const ReaderNursery::Open& open);

}  // namespace percuss
