#pragma once
#include <optional>
#include <string_view>

#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// The name in lower case without underscores: Sample_Rate and SampleRate are equal.
std::string bare_name(std::string_view name);

/// The part of a variable's name after its last dot: "force" of "test.force".
std::string_view field_name(std::string_view name);

/// Whether the variable is a vector: all but one dimension are 1, and it holds two numbers or more.
bool is_mat_vector(const MatVariable& variable);

/// The sampling rate: from the options, else from a number named fs, sample_rate, dt and the like, else from a time
/// vector. Nothing when there is none.
/// errors  InputError: the variable that options.fs_variable names (a rate or a time vector) is missing or holds no
/// real numbers, rates disagree, a time vector is uneven.
std::optional<double> mat_rate_Hz(const MatFile& file, const ReadOptions& options);

/// The value of the scalar variable that matches the earliest of `names`; nothing when none matches. Letter case and
/// underscores are ignored. A name of five letters or more also matches the end of a longer name.
std::optional<double> mat_number(const MatFile& file, std::initializer_list<std::string_view> names);

/// The text of a char variable of this name; empty when there is none.
std::string mat_text(const MatFile& file, std::string_view name);

}  // namespace percuss::acquire
