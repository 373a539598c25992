/* lumen_csv.c - splits lines at commas, reads the names of the columns and then the
 * lines of one of the two tables, and notes every mistake with its line number. */
#include "methods/lumen/lumen_csv.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/lumen/lumen_table_build.h"
#include "model/base/array.h"
#include "model/base/text.h"

enum {
    FIELDS_MOST = 64,
    FIELD_LONGEST = 64,
    FILE_LARGEST = 1 << 24,
};

/* Largest accepted coefficient, and largest accepted Ev/Eh. */
static const double coefficient_most = 2.0, ratio_most = 10.0;

enum column {
    COMPONENT,
    RATIO,
    CEILING,
    WALLS,
    DEPTH,
    POSITION,
    RCR,
    CU,
    WIDTH, /* a width; may occur any number of times */
};

static const char *const column_names[] = {
    [COMPONENT] = "component",
    [RATIO] = "Ev_over_Eh",
    [CEILING] = "ceiling_reflectance",
    [WALLS] = "wall_reflectance",
    [DEPTH] = "depth_over_window_height",
    [POSITION] = "position_percent",
    [RCR] = "rcr",
    [CU] = "cu",
};

/* A line split at its commas, without white space around the fields. */
struct csv_fields {
    int count;
    char text[FIELDS_MOST][FIELD_LONGEST];
};

struct reader {
    struct pp_mistakes *mistakes;
    int number;  /* number of the current line */
    int columns; /* 0: before the line with their names */
    bool sound;  /* true: the columns are those of one of the two tables */
    enum column kinds[FIELDS_MOST];
    struct pp_lumen_axis widths;
    bool top; /* true: the table is for light from above */
    int count, side_capacity, top_capacity, cu_capacity;
    struct pp_lumen_line *side_lines; /* member cu of each line points into `cu`; set at
                                       * the end */
    struct pp_lumen_top_line *top_lines;
    double (*cu)[PP_LUMEN_AXIS_MOST];
};

static bool is_white(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* Splits one line into fields. Notes a mistake and returns false if the line has too
 * many fields for either table, or a field is too long. */
static bool cut_csv_line(struct reader *reader, struct csv_fields *fields,
                         const char *line, size_t length)
{
    fields->count = 0;
    for (size_t start = 0; start <= length;) {
        size_t end = start;
        while (end < length && line[end] != ',')
            end++;
        size_t first = start, last = end;
        while (first < last && is_white(line[first]))
            first++;
        while (last > first && is_white(line[last - 1]))
            last--;
        if (fields->count == FIELDS_MOST || last - first >= FIELD_LONGEST) {
            pp_mistakes_add(
                reader->mistakes, reader->number,
                fields->count == FIELDS_MOST
                    ? "more than %d fields on this line"
                    : "field %d on this line is too long; expected a number or a name",
                fields->count == FIELDS_MOST ? FIELDS_MOST : fields->count + 1);
            return false;
        }
        char *text = fields->text[fields->count++];
        memcpy(text, line + first, last - first);
        text[last - first] = '\0';
        start = end + 1;
    }
    return true;
}

/* Reads a width divided by window height: a number above 0, or inf. */
static bool read_width(const char *text, double *width)
{
    if (strcmp(text, "inf") == 0) {
        *width = INFINITY;
        return true;
    }
    return pp_text_parse_number(text, width) && *width > 0.0;
}

static bool has_column(const struct reader *reader, enum column kind)
{
    for (int i = 0; i < reader->columns; i++)
        if (reader->kinds[i] == kind)
            return true;
    return false;
}

static void unknown_column(struct reader *reader, const char *text)
{
    char written[64], question[128];
    pp_text_excerpt(written, sizeof written, text);
    pp_text_did_you_mean(question, sizeof question, "\"",
                         pp_text_nearest(text, column_names, WIDTH), "\"");
    if (question[0])
        pp_mistakes_add(reader->mistakes, reader->number, "unknown column \"%s\" (%s)",
                        written, question);
    else
        pp_mistakes_add(reader->mistakes, reader->number,
                        "unknown column \"%s\"; expected one of the named columns, or "
                        "a ratio of room width to window height",
                        written);
}

static void add_width(struct reader *reader, double width, const char *text)
{
    struct pp_lumen_axis *widths = &reader->widths;
    if (widths->count == PP_LUMEN_AXIS_MOST)
        pp_mistakes_add(reader->mistakes, reader->number, "more than %d widths",
                        PP_LUMEN_AXIS_MOST);
    else if (widths->count > 0 && !(width > widths->at[widths->count - 1]))
        pp_mistakes_add(reader->mistakes, reader->number,
                        "width %s is out of order; expected ascending widths", text);
    else
        widths->at[widths->count++] = width;
}

/* Notes columns that are missing from, or superfluous in, the kind of table being
 * read. */
static void check_columns(struct reader *reader)
{
    static const enum column side_needs[] = {RATIO, DEPTH, POSITION};
    static const enum column top_needs[] = {RCR, CEILING, WALLS, CU};
    reader->top = has_column(reader, RCR) || has_column(reader, CU);
    const enum column *needs = reader->top ? top_needs : side_needs;
    for (int i = 0; i < (reader->top ? 4 : 3); i++)
        if (!has_column(reader, needs[i]))
            pp_mistakes_add(reader->mistakes, reader->number,
                            "a table for light from %s lacks the column \"%s\"",
                            reader->top ? "above" : "the side", column_names[needs[i]]);
    if (reader->top) {
        static const enum column side_only[] = {COMPONENT, RATIO, DEPTH, POSITION};
        for (int i = 0; i < 4; i++)
            if (has_column(reader, side_only[i]))
                pp_mistakes_add(
                    reader->mistakes, reader->number,
                    "unexpected column \"%s\" in a table for light from above",
                    column_names[side_only[i]]);
    } else if (has_column(reader, CEILING) != has_column(reader, WALLS)) {
        pp_mistakes_add(reader->mistakes, reader->number,
                        "ceiling_reflectance or wall_reflectance is missing; expected "
                        "both or neither");
    }
    if (reader->top ? reader->widths.count > 0 : reader->widths.count == 0)
        pp_mistakes_add(reader->mistakes, reader->number,
                        reader->top
                            ? "unexpected width columns in a table for light from above"
                            : "there are no columns of coefficients; expected "
                              "columns headed with ratios of room width to window "
                              "height (such as 2, or inf)");
}

static void read_header(struct reader *reader, const struct csv_fields *fields)
{
    reader->columns = fields->count;
    for (int i = 0; i < fields->count; i++) {
        const char *text = fields->text[i];
        double width;
        int kind = 0;
        while (kind < WIDTH && strcmp(text, column_names[kind]) != 0)
            kind++;
        if (kind == WIDTH && !read_width(text, &width))
            unknown_column(reader, text);
        else if (kind == WIDTH)
            add_width(reader, width, text);
        for (int k = 0; k < i && kind != WIDTH; k++)
            if (reader->kinds[k] == (enum column)kind)
                pp_mistakes_add(reader->mistakes, reader->number,
                                "duplicate column \"%s\"", text);
        reader->kinds[i] = (enum column)kind;
    }
    check_columns(reader);
}

/* Reads a number in a range; notes a mistake and returns NAN for any other text. */
static double number(struct reader *reader, const char *text, const char *name,
                     double low, bool low_too, double high)
{
    double value;
    if (pp_text_parse_number(text, &value) && value <= high
        && (low_too ? value >= low : value > low))
        return value;
    char written[64];
    pp_text_excerpt(written, sizeof written, text);
    pp_mistakes_add(reader->mistakes, reader->number,
                    *text ? "%s is \"%s\"; expected a number %s%g, up to %g"
                          : "%s is missing%s; expected a number %s%g, up to %g",
                    name, *text ? written : "", low_too ? "from " : "above ", low,
                    high);
    return NAN;
}

static bool is_ground(const char *text)
{
    return strcmp(text, "uniform") == 0 || strcmp(text, "ground") == 0;
}

static int read_position(struct reader *reader, const char *text)
{
    double per_cent;
    if (*text == '\0' || strcmp(text, "average") == 0)
        return PP_LUMEN_AVERAGE;
    if (pp_text_parse_number(text, &per_cent))
        for (int i = 0; i < PP_LUMEN_AVERAGE; i++)
            if (per_cent == 10.0 + 20.0 * i)
                return i;
    char written[64];
    pp_text_excerpt(written, sizeof written, text);
    pp_mistakes_add(
        reader->mistakes, reader->number,
        "position_percent is \"%s\"; expected 10, 30, 50, 70 or 90, or an empty field "
        "for the average",
        written);
    return 0;
}

/* Makes room for one more line. Returns false if memory runs out. */
static bool reserve_line(struct reader *reader)
{
    int wanted = reader->count + 1;
    return pp_array_reserve(&reader->side_lines, &reader->side_capacity, wanted,
                            sizeof *reader->side_lines, NULL)
               == PP_OK
           && pp_array_reserve(&reader->top_lines, &reader->top_capacity, wanted,
                               sizeof *reader->top_lines, NULL)
                  == PP_OK
           && pp_array_reserve(&reader->cu, &reader->cu_capacity, wanted,
                               sizeof *reader->cu, NULL)
                  == PP_OK;
}

static void read_side(struct reader *reader, const struct csv_fields *fields)
{
    struct pp_lumen_line *line = &reader->side_lines[reader->count];
    double *cu = reader->cu[reader->count];
    const char *component = NULL, *ratio = "";
    int width = 0;
    *line = (struct pp_lumen_line){
        .light = NAN, .ceiling = NAN, .walls = NAN, .line = reader->number};
    for (int i = 0; i < fields->count; i++) {
        const char *text = fields->text[i], *name = column_names[CU];
        switch (reader->kinds[i]) {
        case COMPONENT:
            component = text;
            break;
        case RATIO:
            ratio = text;
            break;
        case CEILING:
        case WALLS:
            name = column_names[reader->kinds[i]];
            *(reader->kinds[i] == CEILING ? &line->ceiling : &line->walls) =
                number(reader, text, name, 0.0, true, 1.0);
            break;
        case DEPTH:
            line->depth = number(reader, text, column_names[DEPTH], 0.0, false, 1000.0);
            break;
        case POSITION:
            line->position = read_position(reader, text);
            break;
        case RCR:
        case CU:
            break; /* a column that is not in tables for light from the side */
        case WIDTH:
            cu[width++] =
                number(reader, text, "a coefficient", 0.0, false, coefficient_most);
            break;
        }
    }
    bool ground = *ratio == '\0' || is_ground(ratio);
    if (!ground)
        line->light =
            number(reader, ratio, column_names[RATIO], 0.0, false, ratio_most);
    if (component && strcmp(component, ground ? "ground" : "sky") != 0) {
        char written[64];
        pp_text_excerpt(written, sizeof written, component);
        pp_mistakes_add(
            reader->mistakes, reader->number,
            "component is \"%s\"; expected \"sky\" with a number for Ev_over_Eh, or "
            "\"ground\" without a number",
            written);
    }
}

static void read_top(struct reader *reader, const struct csv_fields *fields)
{
    struct pp_lumen_top_line *line = &reader->top_lines[reader->count];
    *line = (struct pp_lumen_top_line){.line = reader->number};
    for (int i = 0; i < fields->count; i++) {
        const char *text = fields->text[i], *name = "";
        enum column kind = reader->kinds[i];
        if (kind < WIDTH)
            name = column_names[kind];
        if (kind == RCR)
            line->rcr = number(reader, text, name, 0.0, true, 1000.0);
        else if (kind == CEILING)
            line->ceiling = number(reader, text, name, 0.0, true, 1.0);
        else if (kind == WALLS)
            line->walls = number(reader, text, name, 0.0, true, 1.0);
        else
            line->cu = number(reader, text, name, 0.0, false, coefficient_most);
    }
}

/* Reads one line of the file. Returns false if memory runs out. */
static bool read_csv_line(struct reader *reader, const char *text, size_t length)
{
    struct csv_fields fields;
    size_t blank = 0;
    while (blank < length && is_white(text[blank]))
        blank++;
    if (blank == length || text[0] == '#')
        return true;
    if (reader->columns > 0 && !reader->sound)
        return true; /* nothing is read if the columns are wrong */
    if (!cut_csv_line(reader, &fields, text, length))
        return true;
    if (reader->columns == 0) {
        read_header(reader, &fields);
        reader->sound = reader->mistakes->count == 0;
        return true;
    }
    if (fields.count != reader->columns) {
        pp_mistakes_add(reader->mistakes, reader->number,
                        "%d fields on this line; expected %d, one for each column",
                        fields.count, reader->columns);
        return true;
    }
    if (!reserve_line(reader))
        return false;
    (reader->top ? read_top : read_side)(reader, &fields);
    reader->count++;
    return true;
}

/* Replaces the table of the same kind by the one just read. */
static enum pp_status replace_lumen_table(struct reader *reader,
                                          struct pp_lumen_table *table,
                                          struct pp_error *err)
{
    struct pp_lumen_table fresh = {0};
    for (int i = 0; i < reader->count; i++)
        reader->side_lines[i].cu = reader->cu[i];
    enum pp_status status =
        reader->top ? pp_lumen_table_build_top(&fresh.top, reader->top_lines,
                                               reader->count, reader->mistakes, err)
                    : pp_lumen_table_build_side(&fresh.side, &reader->widths,
                                                reader->side_lines, reader->count,
                                                reader->mistakes, err);
    if (status == PP_OK && reader->mistakes->count > 0)
        status = pp_fail(err, PP_BAD_INPUT, "the table has errors");
    if (status != PP_OK) {
        free(fresh.side.made);
        free(fresh.top.cu);
        return status;
    }
    if (reader->top) {
        free(table->top.cu);
        table->top = fresh.top;
    } else {
        free(table->side.made);
        table->side = fresh.side;
    }
    return PP_OK;
}

enum pp_status pp_lumen_csv_parse(struct pp_lumen_table *table, const char *text,
                                  size_t length, struct pp_mistakes *mistakes,
                                  struct pp_error *err)
{
    static const char mark[] = "\xef\xbb\xbf"; /* byte order mark of UTF-8 */
    struct reader reader = {.mistakes = mistakes};
    bool memory = true;
    if (length >= 3 && memcmp(text, mark, 3) == 0) {
        text += 3;
        length -= 3;
    }
    if (memchr(text, '\0', length)) {
        pp_mistakes_add(mistakes, 0, "this is not a text file; expected a CSV table");
        length = 0;
    }
    for (size_t start = 0; start < length && memory;) {
        const char *end = memchr(text + start, '\n', length - start);
        size_t line = end ? (size_t)(end - text) - start : length - start;
        reader.number++;
        memory = read_csv_line(&reader, text + start, line);
        start += line + 1;
    }
    if (reader.count == 0 && mistakes->count == 0)
        pp_mistakes_add(mistakes, 0,
                        reader.columns == 0
                            ? "the file is empty; expected a CSV table"
                            : "there are no lines below the column names; expected at "
                              "least one");
    enum pp_status status = PP_OK;
    if (!memory)
        status = pp_fail_memory(err);
    else if (mistakes->count > 0)
        status = pp_fail(err, PP_BAD_INPUT, "the table has errors");
    else
        status = replace_lumen_table(&reader, table, err);
    free(reader.side_lines);
    free(reader.top_lines);
    free(reader.cu);
    return status;
}

/* Reads a whole file. The caller frees *text, whatever the status. */
static enum pp_status read_file(char **text, size_t *length, FILE *file,
                                const char *path, struct pp_error *err)
{
    int capacity = 0;
    for (;;) {
        enum pp_status status =
            pp_array_reserve(text, &capacity, (int)*length + (1 << 16), 1, err);
        if (status != PP_OK)
            return status;
        size_t got = fread(*text + *length, 1, (size_t)capacity - *length, file);
        *length += got;
        if (got == 0)
            break;
        if (*length > FILE_LARGEST)
            return pp_fail(
                err, PP_BAD_INPUT,
                "%s: the file is too large; expected a table of at most 16 MB", path);
    }
    if (ferror(file))
        return pp_fail(err, errno == EISDIR ? PP_BAD_INPUT : PP_SYSTEM, "%s: %s", path,
                       strerror(errno));
    return PP_OK;
}

enum pp_status pp_lumen_csv_read(struct pp_lumen_table *table, const char *path,
                                 struct pp_mistakes *mistakes, struct pp_error *err)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return pp_fail(err, errno == ENOENT ? PP_BAD_INPUT : PP_SYSTEM, "%s: %s", path,
                       strerror(errno));
    size_t length = 0;
    char *text = NULL;
    enum pp_status status = read_file(&text, &length, file, path, err);
    fclose(file);
    if (status == PP_OK)
        status = pp_lumen_csv_parse(table, text, length, mistakes, err);
    free(text);
    return status;
}
