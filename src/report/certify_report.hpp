#pragma once
#include <cstddef>
#include <string>

#include "metrics/certify.hpp"

namespace percuss {

/// The document percuss/certify/1 (docs/schema/certify.schema.json), indented, with a line end.
std::string certify_json(const Session& session, const Certification& certification);

/// What an operator reads: what to do next, the locations, the shots that do not count and why, the balls that are
/// spent.
std::string certify_text(const Session& session, const Certification& certification, std::size_t width);

/// The shots as a table: location, speeds, value, valid or why not.
std::string certify_csv(const Session& session, const Certification& certification);

/// Performance over the location, as a picture, and the limit.
std::string certify_svg(const Session& session, const Certification& certification);

}  // namespace percuss
