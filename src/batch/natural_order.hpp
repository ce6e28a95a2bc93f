#pragma once
#include <string>

namespace percuss::batch {

/// Whether `a` comes before `b` where numbers in names compare by their value: "hit2.csv" before "hit10.csv".
bool comes_first_naturally(const std::string& a, const std::string& b);

}  // namespace percuss::batch
