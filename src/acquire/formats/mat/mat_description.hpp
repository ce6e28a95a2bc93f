#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "acquire/channels/signal_table.hpp"
#include "acquire/formats/mat/mat_file.hpp"

namespace percuss::acquire {

/// The variable `name`; else the field of this name in the structure of the variable `beside` ("test.point" for
/// "test.force"); else the only field of this name. nullptr if there is none, or if several other structures have one.
const MatVariable* description_variable(const MatFile& file, std::string_view name, std::string_view beside);

/// [count] the number for each channel in the variable or field `name`, see description_variable(); nothing where it is
/// not finite. Nothing for every channel if there is no such variable, or if it does not hold `count` real numbers.
std::vector<std::optional<double>> per_channel(const MatFile& file, const char* name, std::size_t count,
                                               std::string_view beside);

/// [rows] the whole numbers of the hits in the variable or field `name`, see description_variable(); a field with one
/// number states it for all hits. Zeros if there is none. A note names a field of another structure that holds
/// something else. errors  InputError: a variable, or a field beside `beside`, with another number of values or with
/// one that is not whole.
std::vector<int> numbers_of_hits(const MatFile& file, const char* name, std::size_t rows, std::string_view beside,
                                 std::vector<Message>& notes);

/// The number of hits, from the length of `point` or `run`; 0 if the file has neither.
std::size_t stated_hits(const MatFile& file, std::string_view beside);

/// Whether percuss's own layout uses the name for something else than a signal.
bool is_own_description(const std::string& name);

/// Whether the variable may hold a signal: several numbers that are no abscissa, and that percuss's own layout does not
/// use for something else.
bool may_be_signal(const MatVariable& variable);

/// The text of the variable that states the unit of `name`: "accel_unit", "accelUnit", "unit_accel", "units.accel"; for
/// "accel.data" also "accel.unit". Empty for none.
std::string unit_in(const MatFile& file, const std::string& name);

/// errors  InputError: a variable is named as a power spectral density.
void refuse_spectral_densities(const MatFile& file);

/// The variable or field `geometry` as [points][2 or 3], as in Record::geometry. Empty if it is absent or has another
/// shape.
std::vector<std::vector<double>> geometry_in(const MatFile& file, std::string_view beside);

/// Takes the lines and faces between points. Unreadable ones do not make the file an error: another program may use the
/// name for something else.
void take_connections(const MatFile& file, SignalTable& table, std::string_view beside);

}  // namespace percuss::acquire
