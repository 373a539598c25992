/* schedule_file.c - see schedule_file.h. */
#include "cli/assess/schedule_file.h"

#include <string.h>
#include <strings.h>

#include "cli/document_pdf.h"
#include "cli/output.h"
#include "cli/program/program_place.h"
#include "reports/assess/schedule_csv.h"
#include "reports/assess/schedule_xlsx.h"
#include "reports/page/document_html.h"
#include "reports/page/schedule_document.h"

/* Maximum number of columns of values on an HTML page and on a landscape A4 sheet. */
enum { HTML_FIGURES = 9, PDF_FIGURES = 12 };

enum schedule_format {
    SCHEDULE_CSV,
    SCHEDULE_XLSX,
    SCHEDULE_HTML,
    SCHEDULE_PDF,
    SCHEDULE_FORMATS /* number of formats; also the value for an unknown extension */
};

static enum schedule_format format_of(const char *path)
{
    static const char *const extensions[SCHEDULE_FORMATS] = {".csv", ".xlsx", ".html",
                                                             ".pdf"};
    int format = 0;
    for (; format < SCHEDULE_FORMATS; format++) {
        size_t length = strlen(path), extension = strlen(extensions[format]);
        if (length > extension
            && strcasecmp(path + length - extension, extensions[format]) == 0)
            break;
    }
    return (enum schedule_format)format;
}

enum pp_status pp_schedule_file_check(const char *path, struct pp_error *err)
{
    return format_of(path) != SCHEDULE_FORMATS
               ? PP_OK
               : pp_fail(err, PP_BAD_INPUT,
                         "--schedule: expected a name that ends in .csv, .xlsx, .html "
                         "or .pdf, not \"%.100s\"",
                         path);
}

static enum pp_status print_schedule_document(const struct pp_window_schedule *schedule,
                                              bool is_pdf, FILE *out,
                                              struct pp_error *err)
{
    const struct pp_study_room *first = schedule->rows[0].room->room;
    const char *title = pp_study_room_title(first);
    struct pp_document document = {0};
    enum pp_status status = pp_schedule_document(
        &document, schedule, title, pp_building_project(first->building),
        is_pdf ? PDF_FIGURES : HTML_FIGURES, err);
    if (status == PP_OK && is_pdf)
        status = pp_document_pdf(&document, title, "Schedule of windows", true, NULL,
                                 out, err);
    else if (status == PP_OK)
        pp_document_html(&document, title, NULL, out);
    pp_document_clear(&document);
    return status;
}

static enum pp_status write_file(const char *path,
                                 const struct pp_window_schedule *schedule,
                                 struct pp_error *err)
{
    const enum schedule_format format = format_of(path);
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, path, err);
    if (status == PP_OK && format == SCHEDULE_XLSX)
        status = pp_schedule_xlsx(schedule, pp_program_place_temporary(), output.stream,
                                  err);
    else if (status == PP_OK && format == SCHEDULE_CSV)
        pp_schedule_csv(schedule, output.stream);
    else if (status == PP_OK)
        status = print_schedule_document(schedule, format == SCHEDULE_PDF,
                                         output.stream, err);
    return pp_output_close(&output, status, err);
}

enum pp_status pp_schedule_file_write(const char *path,
                                      const struct pp_assessments *all,
                                      struct pp_error *err)
{
    struct pp_window_schedule schedule;
    enum pp_status status =
        pp_window_schedule_of(&schedule, all->list, all->count, err);
    if (status == PP_OK && schedule.count == 0)
        status = pp_fail(err, PP_BAD_INPUT,
                         "--schedule: no skylight or sunlight at windows was assessed; "
                         "expected --for uk-planning, or --criteria with vertical-sky");
    if (status == PP_OK)
        status = write_file(path, &schedule, err);
    pp_window_schedule_clear(&schedule);
    return status;
}
