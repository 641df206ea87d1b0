// What films do to the surfaces of both flanks, over the flank and the face.
#pragma once

#include "dynamics/contact_maps.hpp"
#include "output/results_file.hpp"

namespace gearfilm {

/// Places along and across the flanks, and the maps over them, in /flank/pinion and /flank/wheel. Collective.
void write_contact_maps(ResultsFile& file, const ContactMapPair& maps);

/// What is in them, in the manual's Markdown.
std::string contact_map_markdown();

}  // namespace gearfilm
