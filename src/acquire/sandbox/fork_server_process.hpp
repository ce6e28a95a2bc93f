#pragma once
#include "acquire/sandbox/fork_server.hpp"

namespace percuss::acquire {

/// The nursery's side of a ForkServer: forks readers and buries them, until nobody holds the socket's other end.
void run_fork_server(int own, const ForkServer::Open& open);

}  // namespace percuss::acquire
