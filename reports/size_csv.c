/* size_csv.c - see size_csv.h. */
#include "reports/size_csv.h"

#include <math.h>

#include "model/room/room.h"
#include "reports/parts/format.h"

static int windows_of(const struct pp_room *room)
{
    int count = 0;
    for (int i = 0; i < pp_room_opening_count(room); i++)
        count += pp_room_opening_at(room, i).kind == PP_WINDOW;
    return count;
}

double pp_size_csv_size(const struct pp_size_room_result *result,
                        enum pp_size_change change)
{
    if (!result->answer.room)
        return NAN;
    if (change == PP_CHANGE_NUMBER)
        return windows_of(result->answer.room);
    return result->edit_count > 0
               ? pp_size_report_length(result->edits[0].place, change)
               : NAN;
}

static void put_size_reading(const struct pp_reading *reading, FILE *out)
{
    pp_format_csv_number(100.0 * reading->value, out);
    pp_format_csv_number(100.0 * reading->std_error, out);
}

enum pp_status pp_size_csv(const struct pp_size_results *results, FILE *out,
                           struct pp_error *err)
{
    (void)err;
    fputs("file,room,method,change,target_percent,reached,size,now_percent,"
          "now_std_error,sized_percent,sized_std_error,traced_percent,"
          "traced_std_error,holds,why\r\n",
          out);
    for (int i = 0; i < results->count; i++) {
        const struct pp_size_room_result *result = &results->list[i];
        bool reached = result->answer.verdict == PP_SIZE_REACHED;
        pp_format_csv_field(result->room->file, out);
        fputc(',', out);
        pp_format_csv_field(result->room->world->name, out);
        fputc(',', out);
        pp_format_csv_field(result->method, out);
        fprintf(out, ",%s", pp_size_room_change_words[results->request->change]);
        pp_format_csv_number(100.0 * results->request->target, out);
        fprintf(out, ",%s", reached ? "yes" : "no");
        pp_format_csv_number(pp_size_csv_size(result, results->request->change), out);
        put_size_reading(&result->answer.now, out);
        put_size_reading(&result->answer.reading, out);
        put_size_reading(&result->traced, out);
        fprintf(out, ",%s,",
                !isfinite(result->traced.value) ? ""
                : result->holds                 ? "yes"
                                                : "no");
        pp_format_csv_field(result->why, out);
        fputs("\r\n", out);
    }
    return PP_OK;
}
