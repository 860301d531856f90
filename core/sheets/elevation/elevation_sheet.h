#pragma once

// All that the sheet `elevation` brings to the document.
#include "core/sheets/elevation/elevation.h"
#include "core/sheets/elevation/elevation_edits.h"
#include "core/sheets/elevation/elevation_figure.h"
#include "core/sheets/elevation/elevation_json.h"
#include "core/sheets/elevation/elevation_report.h"
