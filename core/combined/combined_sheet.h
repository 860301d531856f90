#pragma once

// All that the sheet `combined` brings to the document.
#include "core/combined/combined.h"
#include "core/combined/combined_curve.h"
#include "core/combined/combined_edits.h"
#include "core/combined/combined_figure.h"
#include "core/combined/combined_json.h"
#include "core/combined/combined_report.h"
