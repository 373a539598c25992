/* project_table.c - see project_table.h. */
#include "reports/page/project_table.h"

#include <stdbool.h>

void pp_project_table(struct pp_document *document, const struct pp_project *project)
{
    bool any = false;
    for (int i = 0; i < PP_PROJECT_FACTS; i++) {
        const char *fact = pp_project_at(project, i);
        if (!fact)
            continue;
        if (!any) {
            pp_document_table(document);
            pp_document_column(document, PP_COLUMN_LABELS, "%s", "");
            pp_document_column(document, PP_COLUMN_WORDS, "%s", "");
        }
        any = true;
        pp_document_row(document, PP_ROW_CELLS);
        pp_document_cell(document, PP_TONE_PLAIN, "%s", pp_project_facts[i].label);
        pp_document_cell(document, PP_TONE_PLAIN, "%s", fact);
    }
}
