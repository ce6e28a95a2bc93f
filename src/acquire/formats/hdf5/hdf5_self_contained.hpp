#pragma once
#include <string>

namespace percuss::acquire::hdf5 {

/// Refuses a file unless all its data lie within it, before another library opens it. Walks through all groups and
/// references by the addresses of their objects, and reads no data but references. The caller holds a Lock.
/// errors  InputError: the errors of InputHdf5; a link other than a hard one; samples in other files; references to
/// regions; damaged references; more than 100 000 objects, references in a data set, or links in a group; groups within
/// groups more than 32 deep
void require_self_contained(const std::string& path);

}  // namespace percuss::acquire::hdf5
