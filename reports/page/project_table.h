/* project_table.h - the facts of a project as a table in a document. */
#ifndef PP_REPORTS_PAGE_PROJECT_TABLE_H
#define PP_REPORTS_PAGE_PROJECT_TABLE_H

#include "model/results/document.h"
#include "model/room/project.h"

/* Adds a table of the known facts: client, author, date and so on. Adds nothing if no
 * fact is known. */
void pp_project_table(struct pp_document *document, const struct pp_project *project);

#endif
