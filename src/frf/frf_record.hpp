#pragma once
#include "acquire/channels/frf_unit.hpp"
#include "acquire/open_measurement.hpp"
#include "acquire/record/frf_record.hpp"

// Names of acquire that callers also know by this layer.
namespace percuss::frf {

using acquire::converted;
using acquire::Frf;
using acquire::FrfKind;
using acquire::FrfReadOptions;
using acquire::FrfRecord;
using acquire::join_frfs;
using acquire::LineRange;
using acquire::measurement_fork_server;
using acquire::needs_sandbox;
using acquire::open_measurement;
using acquire::open_measurement_forked;
using acquire::parse_frf_kind;
using acquire::PointFrf;

}  // namespace percuss::frf
