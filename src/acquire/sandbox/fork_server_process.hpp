#pragma once
#include "acquire/sandbox/fork_server.hpp"

namespace percuss::acquire {

/// The process of a ForkServer: forks readers and reaps them until the other end of `socket` is closed.
void run_fork_server(int socket, const ForkServer::Open& open);

}  // namespace percuss::acquire
