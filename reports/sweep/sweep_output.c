/* sweep_output.c - see sweep_output.h. */
#include "reports/sweep/sweep_output.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "reports/parts/format.h"
#include "reports/parts/json.h"

/* Prints one run to memory. The caller frees *text. */
static enum pp_status print_run(char **text, pp_sweep_output_run *print,
                                const void *data, int run, struct pp_error *err)
{
    size_t length;
    *text = NULL;
    FILE *out = open_memstream(text, &length);
    if (!out)
        return pp_fail_memory(err);
    enum pp_status status = print(data, run, out, err);
    bool failed = ferror(out);
    if ((fclose(out) != 0 || failed) && status == PP_OK)
        status = pp_fail_memory(err);
    return status;
}

/* ---- CSV ---- */

/* Position after the end of a record. A line end within quotes belongs to a field. */
static const char *behind_record(const char *at)
{
    bool quoted = false;
    for (; *at; at++) {
        quoted ^= *at == '"';
        if (*at == '\n' && !quoted)
            return at + 1;
    }
    return at;
}

static void put_records(const struct pp_sweep *sweep, int run, const char *text,
                        FILE *out)
{
    const char *head_end = behind_record(text);
    for (int i = 0; i < sweep->axis_count && run == 0; i++) {
        pp_format_csv_field(sweep->axes[i].address, out);
        fputc(',', out);
    }
    if (run == 0)
        fwrite(text, 1, (size_t)(head_end - text), out);
    for (const char *at = head_end, *next; *at; at = next) {
        next = behind_record(at);
        for (int i = 0; i < sweep->axis_count; i++) {
            pp_format_csv_field(pp_sweep_value(sweep, run, i), out);
            fputc(',', out);
        }
        fwrite(at, 1, (size_t)(next - at), out);
    }
}

enum pp_status pp_sweep_output_csv(const struct pp_sweep *sweep,
                                   pp_sweep_output_run *print, const void *data,
                                   FILE *out, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int run = 0; run < pp_sweep_count(sweep) && status == PP_OK; run++) {
        char *text;
        status = print_run(&text, print, data, run, err);
        if (status == PP_OK)
            put_records(sweep, run, text, out);
        free(text);
    }
    return status;
}

/* ---- JSON ---- */

/* Adds the value, as a number if it is one, else as text. */
static bool add_value(struct json_object *set, const char *address, const char *value)
{
    double number;
    return pp_text_parse_number(value, &number) ? pp_json_number(set, address, number)
                                                : pp_json_text(set, address, value);
}

static struct json_object *run_object(const struct pp_sweep *sweep, int run,
                                      const char *text)
{
    struct json_object *object = json_object_new_object(),
                       *set = json_object_new_object();
    bool good = object && pp_json_add(object, "set", set);
    for (int i = 0; i < sweep->axis_count && good; i++)
        good = add_value(set, sweep->axes[i].address, pp_sweep_value(sweep, run, i));
    good = good && pp_json_add(object, "result", json_tokener_parse(text));
    return pp_json_whole(object, good);
}

enum pp_status pp_sweep_output_json(const struct pp_sweep *sweep,
                                    pp_sweep_output_run *print, const void *data,
                                    FILE *out, struct pp_error *err)
{
    struct json_object *object = json_object_new_object(),
                       *runs = json_object_new_array();
    bool good = object && pp_json_text(object, "format", "pepperpot-sweep-1");
    good = pp_json_add(object, "runs", runs) && good;
    enum pp_status status = good ? PP_OK : pp_fail_memory(err);
    for (int run = 0; run < pp_sweep_count(sweep) && status == PP_OK; run++) {
        char *text;
        status = print_run(&text, print, data, run, err);
        if (status == PP_OK && !pp_json_append(runs, run_object(sweep, run, text)))
            status = pp_fail_memory(err);
        free(text);
    }
    if (status == PP_OK)
        return pp_json_print(out, object, err);
    json_object_put(object);
    return status;
}
