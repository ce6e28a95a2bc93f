#pragma once
#include <string>
#include <vector>

#include "synth/spec.hpp"

namespace percuss::accuracy {

/// The test of `spec` in one HDF5 file in `folder`, its runs as so many times more channels.
std::vector<std::string> one_file(const synth::SynthSpec& spec, const std::string& folder);

/// `count` CSV files of one hit each: sixteen different ones, over and over.
std::vector<std::string> many_files(synth::SynthSpec spec, std::size_t count, const std::string& folder);

}  // namespace percuss::accuracy
