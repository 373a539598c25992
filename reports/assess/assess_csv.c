/* assess_csv.c - writes findings, or rights of light, one per line. Daylight factors
 * and other fractions are in per cent. */
#include "reports/assess/assess_csv.h"

#include <math.h>

#include "reports/parts/figure_unit.h"
#include "reports/parts/format.h"
#include "studies/criteria/site_table.h"

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
    pp_format_csv_number(scale * finding->grid_error, out);
    pp_format_csv_number(100.0 * finding->reached_over, out);
    pp_format_csv_number(100.0 * finding->over_error, out);
    fputs("\r\n", out);
}

enum pp_status pp_assess_csv(const struct pp_assessments *all, FILE *out,
                             struct pp_error *err)
{
    (void)err;
    fputs("file,room,ref,use,criterion,of,line,existing,proposed,figure,unit,std_error,"
          "wanted,bound,verdict,confidence,note,grid_error,reached_over,over_error\r\n",
          out);
    for (int i = 0; i < all->count; i++)
        for (int k = 0; k < all->list[i].answers.count; k++) {
            const struct pp_answer *answer = &all->list[i].answers.list[k];
            for (int n = 0; n < answer->findings.count; n++)
                put_finding(&all->list[i], answer->criterion, &answer->findings.list[n],
                            out);
        }
    return PP_OK;
}

/* ---- rights of light ---- */

/* Writes the areas of a room. lit NULL: the room is not assessed, and the fields are
 * empty. */
static void put_areas(const struct pp_lit_change *lit, FILE *out)
{
    const double areas[] = {
        lit ? lit->plane_m2 : NAN, lit ? lit->before_m2 : NAN, lit ? lit->lit_m2 : NAN,
        lit ? 100.0 * lit->lit_m2 / lit->plane_m2 : NAN, lit ? lit->lost_m2 : NAN};
    for (size_t i = 0; i < sizeof areas / sizeof *areas; i++)
        pp_format_csv_number(areas[i], out);
    for (int i = 0; i < PP_ZONE_COUNT; i++)
        pp_format_csv_number(lit ? lit->loss.zones_m2[i] : NAN, out);
    pp_format_csv_number(lit ? lit->loss.equivalent_m2 : NAN, out);
}

static void put_rights_row(const struct pp_site_row *row, FILE *out)
{
    const struct pp_study_room *room = row->room->room;
    pp_format_csv_field(room->file, out);
    put_text(room->world->name, out);
    put_text(room->world->ref, out);
    put_text(room->world->use ? pp_room_use_words[room->world->use] : NULL, out);
    put_areas(row->lit, out);
    put_text(pp_finding_verdict(row->finding->verdict), out);
    put_text(row->finding->note, out);
    fputs("\r\n", out);
}

enum pp_status pp_assess_csv_of_site(const struct pp_assessments *all, FILE *out,
                                     struct pp_error *err)
{
    struct pp_site_table table;
    enum pp_status status = pp_site_table_of(&table, all->list, all->count, err);
    bool alone = table.rights_count > 0
                 && !(table.window_count || table.room_count || table.garden_count
                      || table.other_count);
    if (status == PP_OK && !alone)
        status = pp_assess_csv(all, out, err);
    if (status == PP_OK && alone) {
        fputs("file,room,ref,use,area_m2,existing_m2,proposed_m2,share,lost_m2,"
              "lost_front_m2,lost_first_m2,lost_second_m2,lost_makeweight_m2,"
              "lost_as_first_zone_m2,verdict,note\r\n",
              out);
        for (int i = 0; i < table.rights_count; i++)
            put_rights_row(&table.rights[i], out);
        fputs(",sum,,", out);
        put_areas(&table.rights_sum, out);
        fputs(",,\r\n", out);
    }
    pp_site_table_clear(&table);
    return status;
}
