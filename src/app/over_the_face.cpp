#include "app/over_the_face.hpp"

#include "film/domain_margins.hpp"
#include "input/case_with_parameter.hpp"
#include "output/resumable_run.hpp"
#include "output/screen.hpp"

namespace gearfilm {

void run_over_the_face_if_needed(MPI_Comm comm, const CaseInput& given, const std::string& what,
                                 const std::function<void(const CaseInput&)>& run) {
  if (given.run.restart && parameter_of_kept_run(comm, given.run.directory, whole_face_parameter) == "yes") {
    return run(over_whole_face(given));
  }
  try {
    run(given);
  } catch (const EdgesReached& error) {
    say(comm, error.what(), ": ", what, " begins again with films over the whole face (", whole_face_parameter,
        ": yes)");
    CaseInput again = over_whole_face(given);
    again.run.restart = false;
    run(again);
  }
}

}  // namespace gearfilm
