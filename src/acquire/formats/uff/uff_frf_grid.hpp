#pragma once
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "acquire/formats/uff/uff_function.hpp"

namespace percuss::acquire {

using UffFrfs = std::vector<const UffFunction*>;

/// A degree of freedom of a response or of the hammer: name, node, direction.
using UffDofKey = std::tuple<std::string, int, int>;
UffDofKey uff_dof_key(const UffDof& dof);

/// Node and unsigned direction of struck places.
using UffStruckSet = std::set<std::pair<int, int>>;
std::pair<int, int> uff_struck_key(const UffFunction& f);

/// Assigns the degrees of freedom of the FRFs to points and channels.
struct UffFrfGrid {
  bool sensor_roves = false;
  bool by_name = true, by_sign = true;        // whether names and signs tell channels apart
  std::map<UffDofKey, std::size_t> channels;  // the number of each channel, from 1
  UffDofKey channel_key(const UffFunction& f) const;
};

/// Sensors rove if one place was struck and several nodes respond. Channels are numbered in the file's order.
UffFrfGrid uff_frf_grid(const UffFrfs& frfs, const UffStruckSet& struck);

}  // namespace percuss::acquire
