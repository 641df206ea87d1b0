#include "parallel/events.hpp"

#include <array>

namespace gearfilm {
namespace {

constexpr std::size_t kernel_count = static_cast<std::size_t>(Kernel::count);
constexpr std::array<const char*, kernel_count> kernel_names = {
    "FilmDeform", "FilmProps", "FilmResid", "FilmLinear", "FilmJacMult", "SmoothFactor", "SmoothSweep", "MGTransfer"};
std::array<PetscLogEvent, kernel_count> events{};
bool registered = false;

PetscLogEvent event_of(Kernel kernel) {
  register_events();
  return events[static_cast<std::size_t>(kernel)];
}

}  // namespace

void register_events() {
  if (registered) return;
  registered = true;
  PetscClassId film_class = 0;
  petsc_check(PetscClassIdRegister("Film", &film_class));
  for (std::size_t k = 0; k < kernel_count; ++k) {
    petsc_check(PetscLogEventRegister(kernel_names[k], film_class, &events[k]));
  }
}

ScopedEvent::ScopedEvent(Kernel kernel) : event_(event_of(kernel)) { (void)PetscLogEventBegin(event_, 0, 0, 0, 0); }
ScopedEvent::~ScopedEvent() { (void)PetscLogEventEnd(event_, 0, 0, 0, 0); }

ScopedStage::ScopedStage(const char* name) {
  PetscLogStage stage = -1;
  petsc_check(PetscLogStageGetId(name, &stage));
  if (stage < 0) petsc_check(PetscLogStageRegister(name, &stage));
  petsc_check(PetscLogStagePush(stage));
}
ScopedStage::~ScopedStage() { (void)PetscLogStagePop(); }

}  // namespace gearfilm
