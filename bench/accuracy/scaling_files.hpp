#pragma once
#include <string>
#include <vector>

#include "synth/spec.hpp"

namespace percuss::accuracy {

/// Writes the test of `spec` to one HDF5 file in `folder`, with its runs as further channels.
std::vector<std::string> one_file(const synth::SynthSpec& spec, const std::string& folder);

/// Writes `count` CSV files of one hit each, which repeat sixteen different hits.
std::vector<std::string> many_files(synth::SynthSpec spec, std::size_t count, const std::string& folder);

}  // namespace percuss::accuracy
