/* assess_csv.c - puts findings on lines; factors and shares in per cent. */
#include "reports/assess/assess_csv.h"

#include <math.h>

#include "reports/parts/figure_unit.h"
#include "reports/parts/format.h"

static void put_text(const char *text, FILE *out)
{
    fputc(',', out);
    pp_format_csv_field(text, out);
}

static void put_finding(const struct pp_assessment *room,
                        const struct pp_criterion *criterion,
                        const struct pp_finding *finding, FILE *out)
{
    const struct pp_world *world = room->room->world;
    double scale = pp_figure_scale(finding->kind),
           compared = pp_figure_scale(finding->compared);
    pp_format_csv_field(room->room->file, out);
    put_text(world->name, out);
    put_text(world->ref, out);
    put_text(world->use ? pp_room_use_words[world->use] : NULL, out);
    put_text(criterion->name, out);
    put_text(finding->what, out);
    fputc(',', out);
    if (finding->line > 0)
        fprintf(out, "%d", finding->line);
    pp_format_csv_number(compared * finding->before, out);
    pp_format_csv_number(compared * finding->now, out);
    pp_format_csv_number(scale * finding->figure, out);
    put_text(isfinite(finding->figure) ? pp_figure_unit(finding->kind) : NULL, out);
    pp_format_csv_number(scale * finding->std_error, out);
    pp_format_csv_number(scale * finding->wanted, out);
    put_text(isnan(finding->wanted) ? NULL : finding->at_most ? "most" : "least", out);
    put_text(pp_finding_verdict(finding->verdict), out);
    pp_format_csv_number(finding->confidence, out);
    put_text(finding->note, out);
    fputs("\r\n", out);
}

enum pp_status pp_assess_csv(const struct pp_assessments *all, FILE *out,
                             struct pp_error *err)
{
    (void)err;
    fputs("file,room,ref,use,criterion,of,line,existing,proposed,figure,unit,std_error,"
          "wanted,bound,verdict,confidence,note\r\n",
          out);
    for (int i = 0; i < all->count; i++)
        for (int k = 0; k < all->list[i].answer_count; k++) {
            const struct pp_answer *answer = &all->list[i].answers[k];
            for (int n = 0; n < answer->findings.count; n++)
                put_finding(&all->list[i], answer->criterion, &answer->findings.list[n],
                            out);
        }
    return PP_OK;
}
