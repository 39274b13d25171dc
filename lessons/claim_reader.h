// How does a [[step.claim]] become a Claim?
#pragma once

#include "lessons/claim.h"
#include "lessons/lesson.h"
#include "lessons/text_rules.h"
#include "lessons/toml_document.h"

namespace halfdisk {

/// What the step's text says is measured as the step is set, but for what the claim itself sets. Its sentence
/// may name the text's numbers. Throws InputError.
Claim readClaim(const LessonText& text, const TomlValue& value, const Scene& scene, const StepValues& step);

}  // namespace halfdisk
