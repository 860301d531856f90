#pragma once

// All that the sheet `elevation` brings to the document.
#include "core/elevation/elevation.h"
#include "core/elevation/elevation_edits.h"
#include "core/elevation/elevation_figure.h"
#include "core/elevation/elevation_json.h"
#include "core/elevation/elevation_report.h"
