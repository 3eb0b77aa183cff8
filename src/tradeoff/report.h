// What was measured, as a table for people and as JSON and CSV for scripts.
#pragma once

#include <iosfwd>
#include <vector>

#include "tradeoff/measurement.h"
#include "tradeoff/provenance.h"

namespace cdpr_kinetostatics {

void writeTable(const RobotTrade& trade, std::ostream* out);

// {"machine": {...}, "reference": {...}, "robots": [{..., "rows": [...], "recommendations": [...]}]}. SI units; what
// is not known is null.
void writeJson(const Provenance& provenance, const std::vector<RobotTrade>& trades, std::ostream* out);

// One line for each row, after lines of comment (#) about the machine. What is not known is empty.
void writeCsv(const Provenance& provenance, const std::vector<RobotTrade>& trades, std::ostream* out);

}  // namespace cdpr_kinetostatics
