#pragma once

// All that the sheet `subdivision` brings to the document.
#include "core/sheets/subdivision/subdivision.h"
#include "core/sheets/subdivision/subdivision_edits.h"
#include "core/sheets/subdivision/subdivision_figure.h"
#include "core/sheets/subdivision/subdivision_json.h"
#include "core/sheets/subdivision/subdivision_report.h"
