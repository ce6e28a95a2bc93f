#pragma once
#include <string>

namespace percuss::acquire {

/// Requires that each array of a MAT file of level 5 stores as many numbers as its dimensions state, also compressed,
/// in structures and in cells: the library leaves missing numbers uninitialised. The caller has checked the file with
/// require_complete_mat.
/// errors  InputError: an array stores fewer numbers, or numbers of an unknown type; a compressed variable is damaged,
/// or longer than claim_limit_bytes allows.
void require_stored_numbers(const std::string& path);

}  // namespace percuss::acquire
