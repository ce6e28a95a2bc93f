#pragma once
#include <optional>
#include <string_view>

#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// The part of a variable's name after its last dot: "force" of "test.force".
std::string_view field_name(std::string_view name);

/// Whether the variable is a vector: all but one dimension are 1, and it holds two numbers or more.
bool is_mat_vector(const MatVariable& variable);

/// The sampling rate: by the options, else a number named fs, sample_rate, dt and the like, else a time vector. Nothing
/// when there is none.
/// errors  InputError: the variable that options.fs_variable names is not a number, rates disagree, a time vector is
/// uneven.
std::optional<double> mat_rate_Hz(const MatFile& file, const ReadOptions& options);

/// The number in a variable of one number whose name is among `names` (letter case and underscores aside, also as the
/// end of a longer name); nothing when there is none.
std::optional<double> mat_number(const MatFile& file, std::initializer_list<std::string_view> names);

/// The text of a char variable of this name; empty when there is none.
std::string mat_text(const MatFile& file, std::string_view name);

}  // namespace percuss::acquire
