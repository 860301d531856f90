#pragma once

// All that the sheet `subdivision` brings to the document.
#include "core/subdivision/subdivision.h"
#include "core/subdivision/subdivision_edits.h"
#include "core/subdivision/subdivision_figure.h"
#include "core/subdivision/subdivision_json.h"
#include "core/subdivision/subdivision_report.h"
