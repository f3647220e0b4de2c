// Judging contacts: all of sim/quality, with files and reports of contacts alone.
//
//   quality.h          contacts in, numbers out
//   contacts_file.h    contacts from a file
//   contacts_report.h  what a report says of them
//   report_html.h      a report as one file for a browser
#pragma once

#include "planner/results/contacts_file.h"
#include "planner/show/report/contacts_report.h"
#include "planner/show/report/report_html.h"
#include "sim/quality/quality.h"
