#pragma once
/// Time and memory that one analysis may take. Where an analysis needs more, its accessors throw BudgetSpent. The
/// functions of models have no budget. The commands `percuss model beam`, `impact`, `bat` and `trampoline` have one.
///
/// @code
/// #include <iostream>
/// #include <percuss/analysis.hpp>
/// #include <percuss/budget.hpp>
/// #include <percuss/synth.hpp>
///
/// int main() {
///   const percuss::Analysis analysis(percuss::synthesise_preset("composite-bat").record,
///                                    {.budget = percuss::Budget{.time_s = 1e-6}});
///   try {
///     analysis.modes();
///   } catch (const percuss::BudgetSpent& error) {
///     std::cout << error.what() << '\n';
///   }
/// }
/// @endcode
#include <percuss/error.hpp>

#include <cstdint>
#include <limits>
#include <string>

namespace percuss {

/// Limits of one analysis. A Budget without values has no limit; default_budget() gives the usual limits.
struct Budget {
  double time_s = std::numeric_limits<double>::infinity();  // wall-clock time of its computations
  std::uint64_t memory_bytes = std::numeric_limits<std::uint64_t>::max();
};

/// The budget of an analysis whose options state none: 120 s plus 2 s per megabyte of input, and 2 GiB plus 16 times
/// the input.
Budget default_budget(std::uint64_t input_bytes);

enum class Resource { time, memory };
enum class BudgetedWork { analysis, model };

/// An analysis or a model needs more than its budget.
class BudgetSpent : public InputError {
 public:
  BudgetSpent(Resource resource, const Budget& budget, const std::string& where,
              BudgetedWork work = BudgetedWork::analysis);
  Resource resource() const { return resource_; }

 private:
  Resource resource_;
};

}  // namespace percuss
