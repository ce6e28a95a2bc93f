#pragma once
#include "acquire/sandbox/fork_server.hpp"

namespace percuss::acquire {

/// The process of a ForkServer: forks readers and reaps them until the other end of the socket is closed.
void run_fork_server(int own, const ForkServer::Open& open);

}  // namespace percuss::acquire
