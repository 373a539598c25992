/* lumen_option.c - reads the option --lumen-table, and loads one or two coefficient
 * files. */
#include "cli/lumen_option.h"

#include "cli/message.h"
#include "methods/lumen/lumen_csv.h"

static enum pp_status read_file_name(const char *text, void *place,
                                     struct pp_error *err)
{
    struct pp_lumen_files *files = place;
    if (*text == '\0')
        return pp_fail(err, PP_BAD_INPUT, "the name of a file");
    if (files->count == PP_LUMEN_FILES_MOST)
        return pp_fail(err, PP_BAD_INPUT,
                       "at most two files, one for light from the side and one for "
                       "light from above");
    files->list[files->count++] = text;
    return PP_OK;
}

const struct pp_option pp_lumen_option[] = {
    {"lumen-table", 0, "FILE",
     "CSV file with coefficients of utilization for the lumen method, for light from "
     "the side or from above, instead of the built-in table. Repeat the option to give "
     "both.",
     read_file_name, 0},
    {0},
};

static enum pp_exit load_file(struct pp_lumen_table *table, const char *file)
{
    struct pp_error err = {0};
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, file);
    enum pp_exit exit_status = PP_EXIT_DONE;
    if (pp_lumen_csv_read(table, file, &mistakes, &err) != PP_OK)
        exit_status = mistakes.count > 0 ? pp_message_mistakes(&mistakes)
                                         : pp_message_error(&err);
    pp_mistakes_clear(&mistakes);
    return exit_status;
}

enum pp_exit pp_lumen_option_load(struct pp_lumen_table **table,
                                  const struct pp_lumen_files *files)
{
    struct pp_error err;
    enum pp_exit exit_status = PP_EXIT_DONE;
    *table = NULL;
    if (files->count > 0 && pp_lumen_table_create(table, &err) != PP_OK)
        return pp_message_error(&err);
    for (int i = 0; i < files->count; i++) {
        enum pp_exit own = load_file(*table, files->list[i]);
        exit_status = own != PP_EXIT_DONE ? own : exit_status;
    }
    if (exit_status != PP_EXIT_DONE) {
        pp_lumen_table_destroy(*table);
        *table = NULL;
    }
    return exit_status;
}
