// Inputs of `moraine blast` that follow from others.
#pragma once

#include "app/blast_input.hpp"
#include "app/blast_reader.hpp"

namespace moraine {

/// Reflection and pulse take their front from a charge where no pressure is given.
bool from_charge(BlastReader const& reader, TopicCommand const& command);

/// Refuses what has no say beside a given front, and a duration beside a front of a charge.
void refuse_two_fronts(BlastReader& reader, TopicCommand const& command,
                       BlastOptions const& options);

/// Front, duration and impulse of a charge by Kingery-Bulmash, in the air of the situation; the
/// impulse [Pa s] only where the history needs one.
void derive_front(BlastReader const& reader, BlastOptions const& options, blast::Topic topic,
                  BlastInput& input, double& impulse);

/// Decay of Friedlander's history from an impulse [Pa s]; nothing for an unknown one.
void derive_decay(BlastReader& reader, BlastInput& input, double impulse);

/// Coupling of a buried charge: one from a depth of 2 ft/lb^(1/3) on, and below it an input.
void derive_coupling(BlastReader& reader, blast::Situation& situation);

}  // namespace moraine
