/* schedule_csv.c - see schedule_csv.h. */
#include "reports/assess/schedule_csv.h"

#include "reports/parts/format.h"

void pp_schedule_csv(const struct pp_window_schedule *schedule, FILE *out)
{
    static const char *const names[PP_SCHEDULE_CHANGES] = {
        "vsc", "sun_year", "sun_winter", "lit_area", "vsc_unshaded"};
    fputs("file,room,ref,use,level_m,window", out);
    for (int k = 0; k < PP_SCHEDULE_CHANGES; k++)
        fprintf(out, ",%s_existing,%s_proposed,%s_loss_percent,%s_ratio", names[k],
                names[k], names[k], names[k]);
    fputs(",sun_hours,vsc_verdict", out);
    for (int k = 0; k < PP_SCHEDULE_CHANGES; k++)
        fprintf(out, ",%s_cumulative", names[k]);
    fputs(",address\r\n", out);
    for (int i = 0; i < schedule->count; i++) {
        const struct pp_schedule_row *row = &schedule->rows[i];
        const struct pp_world *world = row->room->room->world;
        const char *verdict = pp_finding_verdict(row->verdict);
        const char *texts[] = {row->room->room->file, world->name, world->ref,
                               world->use ? pp_room_use_words[world->use] : NULL};
        for (int t = 0; t < 4; t++) {
            fputs(t > 0 ? "," : "", out);
            pp_format_csv_field(texts[t], out);
        }
        pp_format_csv_number(row->level_m, out);
        fputc(',', out);
        pp_format_csv_field(row->window, out);
        for (int k = 0; k < PP_SCHEDULE_CHANGES; k++) {
            double scale = pp_schedule_scale((enum pp_schedule_quantity)k);
            pp_format_csv_number(scale * row->changes[k].existing, out);
            pp_format_csv_number(scale * row->changes[k].proposed, out);
            pp_format_csv_number(100.0 * pp_schedule_loss(row->changes[k]), out);
            pp_format_csv_number(pp_schedule_ratio(row->changes[k]), out);
        }
        fprintf(out, ",%s,%s", schedule->probable ? "probable" : "possible",
                verdict ? verdict : "");
        for (int k = 0; k < PP_SCHEDULE_CHANGES; k++)
            pp_format_csv_number(pp_schedule_scale((enum pp_schedule_quantity)k)
                                     * row->changes[k].cumulative,
                                 out);
        fputc(',', out);
        pp_format_csv_field(world->address, out);
        fputs("\r\n", out);
    }
}
