#include "numerics/tuned.hpp"

#include <cmath>
#include <cstdlib>
#include <string>

#include "gearfilm/error.hpp"
#include "parallel/petsc.hpp"

namespace gearfilm {

// Set before any constant is made: an initialisation without code.
TunedConstant* TunedConstant::last_made_ = nullptr;

TunedConstant::TunedConstant(const char* name, double value, bool whole, const char* meaning) noexcept
    : name_(name), meaning_(meaning), whole_(whole), default_(value), value_(value), next_(last_made_) {
  last_made_ = this;
}

void TunedConstant::read_all() {
  for (TunedConstant* constant = last_made_; constant; constant = constant->next_) {
    const std::string option = std::string("-") + constant->name_;
    const char* text = nullptr;
    PetscBool given = PETSC_FALSE;
    petsc_check(PetscOptionsFindPair(nullptr, nullptr, option.c_str(), &text, &given));
    constant->value_ = constant->default_;
    if (!given) continue;
    const std::string value = text ? text : "";
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    const bool wrong = value.empty() || *end != '\0' || !(number > 0.0) || number > 1e9;
    if (wrong || (constant->whole_ && number != std::floor(number))) {
      throw InputError("option ", option, ": '", value, "' is no ", constant->whole_ ? "whole " : "",
                       "number above zero; give one, or leave it at ", constant->default_);
    }
    constant->value_ = number;
  }
}

}  // namespace gearfilm
