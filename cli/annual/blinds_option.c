/* blinds_option.c - see blinds_option.h. */
#include "cli/annual/blinds_option.h"

#include <stdlib.h>
#include <string.h>

#include "model/base/read_file.h"
#include "model/base/text.h"

enum { FILE_MOST = 64 << 20 };

enum pp_status pp_blinds_option_read(const char *text, void *place,
                                     struct pp_error *err)
{
    static const struct {
        const char *word;
        enum pp_blinds control;
    } words[] = {{"lm83", PP_BLINDS_LM83},
                 {"never", PP_BLINDS_NEVER},
                 {"none", PP_BLINDS_NEVER},
                 {"always", PP_BLINDS_ALWAYS}};
    struct pp_blinds_choice *choice = place;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(text, words[i].word) == 0) {
            choice->control = words[i].control;
            choice->is_given = true;
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT, "lm83, always, never or none");
}

enum pp_status pp_blinds_option_check(struct pp_blinds_choice *choice,
                                      struct pp_error *err)
{
    if (choice->file && choice->is_given)
        return pp_fail(err, PP_BAD_INPUT,
                       "--blinds cannot be combined with --blinds-schedule");
    if (choice->file)
        choice->control = PP_BLINDS_SCHEDULE;
    return PP_OK;
}

/* Ends the text at its last character that is not white space, and returns its first. */
static char *trimmed(char *text)
{
    size_t length = strlen(text);
    while (length > 0 && pp_text_is_white(text[length - 1]))
        text[--length] = '\0';
    while (pp_text_is_white(*text))
        text++;
    return text;
}

/* Reads the value at the end of a line. is_heading: true if the line may be a heading;
 * *has: true if it has a value. */
static enum pp_status read_line(const struct pp_blinds_choice *choice, char *line,
                                int number, bool is_heading, bool *has,
                                unsigned char *value, struct pp_error *err)
{
    char excerpt[48];
    double closed;
    line = trimmed(line);
    *has = false;
    if (!*line || *line == '#')
        return PP_OK;
    char *comma = strrchr(line, ',');
    const char *field = comma ? trimmed(comma + 1) : line;
    bool good = pp_text_parse_number(field, &closed);
    if (good && (closed == 0.0 || closed == 1.0)) {
        *has = true;
        *value = closed == 1.0;
        return PP_OK;
    }
    if (!good && is_heading)
        return PP_OK;
    return pp_fail(err, PP_BAD_INPUT,
                   "%s:%d: the last field is \"%s\"; expected 1 (closed) or 0 (open)",
                   pp_read_file_title(choice->file), number,
                   pp_text_excerpt(excerpt, sizeof excerpt, field));
}

static enum pp_status read_values(struct pp_blinds_choice *choice, char *text,
                                  int records, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    bool is_first = true;
    for (int number = 1; text && status == PP_OK; number++) {
        char *end = strchr(text, '\n');
        unsigned char value = 0;
        bool has;
        if (end)
            *end++ = '\0';
        bool is_text = *text && *text != '#' && *text != '\r';
        status = read_line(choice, text, number, is_first, &has, &value, err);
        is_first &= !is_text;
        if (status == PP_OK && has && choice->count++ < records)
            choice->schedule[choice->count - 1] = value;
        text = end;
    }
    if (status == PP_OK && choice->count != records)
        status = pp_fail(err, PP_BAD_INPUT,
                         "%s: the schedule has %d values; expected %d, one for each "
                         "record of the weather file",
                         pp_read_file_title(choice->file), choice->count, records);
    return status;
}

enum pp_status pp_blinds_option_load(struct pp_blinds_choice *choice, int records,
                                     struct pp_error *err)
{
    char *bytes;
    size_t length;
    if (!choice->file)
        return PP_OK;
    enum pp_status status = pp_read_file(&bytes, &length, choice->file, FILE_MOST, err);
    if (status != PP_OK)
        return status;
    choice->schedule = calloc((size_t)records + 1, 1);
    choice->count = 0;
    if (!choice->schedule) {
        free(bytes);
        return pp_fail_memory(err);
    }
    status = length > FILE_MOST
                 ? pp_fail(err, PP_BAD_INPUT, "%s: the schedule is larger than 64 MB",
                           pp_read_file_title(choice->file))
                 : read_values(choice, bytes, records, err);
    free(bytes);
    return status;
}

void pp_blinds_option_clear(struct pp_blinds_choice *choice)
{
    free(choice->schedule);
    choice->schedule = NULL;
}
