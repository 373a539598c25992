/* schedule_xlsx.c - see schedule_xlsx.h. The library writes only to named files, so the
 * workbook is a temporary file that is copied to the output. */
#include "reports/assess/schedule_xlsx.h"

#include "config.h"

#ifndef HAVE_XLSXWRITER

enum pp_status pp_schedule_xlsx(const struct pp_window_schedule *schedule,
                                const char *folder, FILE *out, struct pp_error *err)
{
    (void)schedule, (void)folder, (void)out;
    return pp_fail(err, PP_BAD_INPUT,
                   "this program was built without libxlsxwriter; expected a "
                   "schedule file whose name ends in .csv");
}

#else

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <xlsxwriter.h>

#include "studies/criteria/br209_count.h"

enum { KEYS = 6, PARTS = 5, HEAD_ROWS = 2 };

/* Cell formats for heads, figures, ratios, and losses by band. */
struct formats {
    lxw_format *head, *figure, *ratio;
    lxw_format *loss[PP_LOSS_BANDS];
};

static void make_formats(struct formats *formats, lxw_workbook *workbook)
{
    static const lxw_color_t fills[PP_LOSS_BANDS] = {0xFFFFFF, 0xFFF2CC, 0xF8CBAD,
                                                     0xF4A6A6};
    formats->head = workbook_add_format(workbook);
    format_set_bold(formats->head);
    format_set_text_wrap(formats->head);
    formats->figure = workbook_add_format(workbook);
    format_set_num_format(formats->figure, "0.00");
    formats->ratio = workbook_add_format(workbook);
    format_set_num_format(formats->ratio, "0.000");
    for (int i = 0; i < PP_LOSS_BANDS; i++) {
        formats->loss[i] = workbook_add_format(workbook);
        format_set_num_format(formats->loss[i], "0.0");
        if (i > 0)
            format_set_bg_color(formats->loss[i], fills[i]);
    }
}

static void put_figure_cell(lxw_worksheet *sheet, int row, int column, double value,
                            lxw_format *format)
{
    if (isfinite(value))
        worksheet_write_number(sheet, (lxw_row_t)row, (lxw_col_t)column, value, format);
}

static void put_text_cell(lxw_worksheet *sheet, int row, int column, const char *text,
                          lxw_format *format)
{
    if (text && *text)
        worksheet_write_string(sheet, (lxw_row_t)row, (lxw_col_t)column, text, format);
}

static lxw_format *loss_format(const struct formats *formats, double loss)
{
    int band = 0;
    while (band + 1 < PP_LOSS_BANDS && loss >= pp_loss_bands[band + 1])
        band++;
    return formats->loss[band];
}

/* Number of columns for each quantity. The last of PARTS columns is the cumulative
 * state. */
static int parts_of(const struct pp_window_schedule *schedule)
{
    return schedule->has_cumulative ? PARTS : PARTS - 1;
}

static void put_heads(lxw_worksheet *sheet, const struct formats *formats,
                      const struct pp_window_schedule *schedule)
{
    const int count = parts_of(schedule);
    static const char *const keys[KEYS] = {"room",     "ref",    "use",
                                           "level, m", "window", "address"},
                             *const parts[PARTS] = {"existing", "proposed", "loss, %",
                                                    "ratio", "cumulative"};
    for (int i = 0; i < KEYS; i++)
        put_text_cell(sheet, 1, i, keys[i], formats->head);
    for (int k = 0; k < PP_SCHEDULE_CHANGES; k++) {
        char title[PP_SCHEDULE_TITLE];
        pp_window_schedule_title(title, schedule, (enum pp_schedule_quantity)k);
        worksheet_merge_range(sheet, 0, (lxw_col_t)(KEYS + count * k), 0,
                              (lxw_col_t)(KEYS + count * k + count - 1), title,
                              formats->head);
        for (int p = 0; p < count; p++)
            put_text_cell(sheet, 1, KEYS + count * k + p, parts[p], formats->head);
    }
    put_text_cell(sheet, 1, KEYS + count * PP_SCHEDULE_CHANGES, "BR 209, sky",
                  formats->head);
    worksheet_freeze_panes(sheet, HEAD_ROWS, KEYS);
    worksheet_set_column(sheet, 0, 0, 20.0, NULL);
}

static void put_schedule_row(lxw_worksheet *sheet, const struct formats *formats,
                             int at, const struct pp_schedule_row *row, int parts)
{
    const struct pp_world *world = row->room->room->world;
    put_text_cell(sheet, at, 0, world->name, NULL);
    put_text_cell(sheet, at, 1, world->ref, NULL);
    put_text_cell(sheet, at, 2, world->use ? pp_room_use_words[world->use] : NULL,
                  NULL);
    put_figure_cell(sheet, at, 3, row->level_m, formats->figure);
    put_text_cell(sheet, at, 4, row->window, NULL);
    put_text_cell(sheet, at, 5, world->address, NULL);
    for (int k = 0; k < PP_SCHEDULE_CHANGES; k++) {
        double scale = pp_schedule_scale((enum pp_schedule_quantity)k);
        double loss = pp_schedule_loss(row->changes[k]);
        int column = KEYS + parts * k;
        put_figure_cell(sheet, at, column, scale * row->changes[k].existing,
                        formats->figure);
        put_figure_cell(sheet, at, column + 1, scale * row->changes[k].proposed,
                        formats->figure);
        put_figure_cell(sheet, at, column + 2, 100.0 * loss,
                        loss_format(formats, loss));
        put_figure_cell(sheet, at, column + 3, pp_schedule_ratio(row->changes[k]),
                        formats->ratio);
        if (parts == PARTS)
            put_figure_cell(sheet, at, column + 4, scale * row->changes[k].cumulative,
                            formats->figure);
    }
    put_text_cell(sheet, at, KEYS + parts * PP_SCHEDULE_CHANGES,
                  pp_finding_verdict(row->verdict), NULL);
}

/* Writes the workbook to a file. */
static enum pp_status write_workbook(const struct pp_window_schedule *schedule,
                                     const char *path, const char *folder,
                                     struct pp_error *err)
{
    lxw_workbook_options options = {.tmpdir = (char *)folder};
    lxw_workbook *workbook = workbook_new_opt(path, &options);
    if (!workbook)
        return pp_fail_memory(err);
    /* The creation time is fixed (1 January 2000). Otherwise libxlsxwriter would store
     * the current time, and files would differ between runs. */
    char title[] = "Schedule of windows";
    lxw_doc_properties properties = {.title = title, .created = 946684800};
    struct formats formats;
    workbook_set_properties(workbook, &properties);
    make_formats(&formats, workbook);
    lxw_worksheet *sheet = workbook_add_worksheet(workbook, "Windows");
    put_heads(sheet, &formats, schedule);
    for (int i = 0; i < schedule->count; i++)
        put_schedule_row(sheet, &formats, HEAD_ROWS + i, &schedule->rows[i],
                         parts_of(schedule));
    lxw_error error = workbook_close(workbook);
    return error == LXW_NO_ERROR
               ? PP_OK
               : pp_fail(err, PP_SYSTEM, "the workbook cannot be written: %s",
                         lxw_strerror(error));
}

static enum pp_status copy_file(const char *path, FILE *out, struct pp_error *err)
{
    char bytes[4096];
    FILE *in = fopen(path, "rb");
    if (!in)
        return pp_fail(err, PP_SYSTEM, "the workbook cannot be read back");
    for (size_t count; (count = fread(bytes, 1, sizeof bytes, in)) > 0;)
        fwrite(bytes, 1, count, out);
    fclose(in);
    return PP_OK;
}

enum pp_status pp_schedule_xlsx(const struct pp_window_schedule *schedule,
                                const char *folder, FILE *out, struct pp_error *err)
{
    char path[PATH_MAX];
    int length = snprintf(path, sizeof path, "%s/pepperpot-xlsx-XXXXXX", folder);
    int file = (size_t)length < sizeof path ? mkstemp(path) : -1;
    if (file < 0)
        return pp_fail(err, PP_SYSTEM, "no temporary file can be created in %s",
                       folder);
    close(file);
    enum pp_status status = write_workbook(schedule, path, folder, err);
    if (status == PP_OK)
        status = copy_file(path, out, err);
    unlink(path);
    return status;
}

#endif
