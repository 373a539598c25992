/* other_values.c - reads the header, then one value per line. Error messages name file
 * and line. */
#include "cli/compare/other_values.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/read_file.h"
#include "model/base/text.h"
#include "model/room/position.h"

static const size_t FILE_MOST = (size_t)64 << 20;
enum { COLUMNS_MOST = 64, POINTS_MOST = 100000, LINE_MOST = 4096 };

enum csv_column { PASSED_OVER, X, Y, Z, NX, NY, NZ, VALUE, COLUMN_KINDS };

struct csv_column_name {
    const char *name;
    enum csv_column column;
    enum pp_other_unit unit;
};

static const struct csv_column_name names[] = {
    {"x", X, PP_OTHER_UNKNOWN},
    {"y", Y, PP_OTHER_UNKNOWN},
    {"z", Z, PP_OTHER_UNKNOWN},
    {"nx", NX, PP_OTHER_UNKNOWN},
    {"ny", NY, PP_OTHER_UNKNOWN},
    {"nz", NZ, PP_OTHER_UNKNOWN},
    {"df_percent", VALUE, PP_OTHER_PERCENT},
    {"value_percent", VALUE, PP_OTHER_PERCENT},
    {"percent", VALUE, PP_OTHER_PERCENT},
    {"df_%", VALUE, PP_OTHER_PERCENT},
    {"df [%]", VALUE, PP_OTHER_PERCENT},
    {"df_fraction", VALUE, PP_OTHER_FRACTION},
    {"fraction", VALUE, PP_OTHER_FRACTION},
    {"lux", VALUE, PP_OTHER_LUX},
    {"lx", VALUE, PP_OTHER_LUX},
    {"illuminance", VALUE, PP_OTHER_LUX},
    {"illuminance_lx", VALUE, PP_OTHER_LUX},
    {"e_lx", VALUE, PP_OTHER_LUX},
    {"e [lx]", VALUE, PP_OTHER_LUX},
    {"illuminance [lx]", VALUE, PP_OTHER_LUX},
    {"illuminance (lx)", VALUE, PP_OTHER_LUX},
    {"illuminance [lux]", VALUE, PP_OTHER_LUX},
    {"e (lx)", VALUE, PP_OTHER_LUX},
    {"df (%)", VALUE, PP_OTHER_PERCENT},
    {"daylight factor [%]", VALUE, PP_OTHER_PERCENT},
    {"daylight factor (%)", VALUE, PP_OTHER_PERCENT},
    {"df", VALUE, PP_OTHER_UNKNOWN},
    {"daylight_factor", VALUE, PP_OTHER_UNKNOWN},
    {"value", VALUE, PP_OTHER_UNKNOWN},
    {"label", PASSED_OVER, PP_OTHER_UNKNOWN},
    {"name", PASSED_OVER, PP_OTHER_UNKNOWN},
    {"point", PASSED_OVER, PP_OTHER_UNKNOWN},
    {"id", PASSED_OVER, PP_OTHER_UNKNOWN},
};
enum { NAME_COUNT = sizeof names / sizeof names[0] };

/* State of the reader between lines. */
struct csv_reading {
    const char *file;
    int line;
    enum csv_column columns[COLUMNS_MOST];
    int column_count; /* 0: the header has not been read */
    bool has[COLUMN_KINDS];
    const char *separators; /* characters that separate fields, found in the header */
    struct pp_other_values *values;
    int space;
};

/* Removes blanks and quotes at both ends of a word, in place. */
static char *trim(char *word)
{
    word += strspn(word, " \t\r\"");
    size_t length = strlen(word);
    while (length > 0 && strchr(" \t\r\"", word[length - 1]))
        length--;
    word[length] = '\0';
    return word;
}

/* Removes the unit after the name of a coordinate, as in "x [m]", "y (m)" or "z_m". */
static void drop_metres(char *word)
{
    static const char *const units[] = {"[m]", "(m)", "_m"};
    size_t length = strlen(word);
    for (int i = 0; i < 3; i++) {
        size_t unit = strlen(units[i]);
        if (length <= unit || !strchr("xyz", word[0])
            || strcmp(word + length - unit, units[i]) != 0)
            continue;
        length -= unit;
        while (length > 1 && word[length - 1] == ' ')
            length--;
        word[length] = '\0';
        return;
    }
}

static enum pp_status take_name(struct csv_reading *reading, char *word,
                                struct pp_error *err)
{
    char shown[64];
    const char *known[NAME_COUNT];
    for (char *c = word; *c; c++)
        *c = (char)tolower((unsigned char)*c);
    drop_metres(word);
    for (int i = 0; i < NAME_COUNT; i++) {
        enum csv_column column = names[i].column;
        known[i] = names[i].name;
        if (strcmp(word, names[i].name) != 0)
            continue;
        if (column != PASSED_OVER && reading->has[column])
            return pp_fail(err, PP_BAD_INPUT,
                           "%.200s:%d: there is a second column \"%s\"; expected only "
                           "one column of %s",
                           reading->file, reading->line, word,
                           column == VALUE ? "values" : word);
        reading->has[column] = true;
        reading->columns[reading->column_count++] = column;
        if (column == VALUE)
            reading->values->unit = names[i].unit;
        return PP_OK;
    }
    return pp_text_unknown(err, word, known, NAME_COUNT, NULL,
                           "%.200s:%d: unknown column \"%s\"", reading->file,
                           reading->line, pp_text_excerpt(shown, sizeof shown, word));
}

static enum pp_status check_header(struct csv_reading *reading, struct pp_error *err)
{
    const bool *has = reading->has;
    const char *lacking = !has[VALUE]         ? "values, such as df_percent"
                          : has[X] != has[Y]  ? "both x and y"
                          : has[Z] && !has[X] ? "x and y with z"
                          : has[NX] != has[NY] || has[NX] != has[NZ]
                              ? "all of nx, ny and nz"
                          : has[NX] && !has[X] ? "x and y with nx, ny and nz"
                                               : NULL;
    reading->values->has_places = has[X];
    return lacking ? pp_fail(err, PP_BAD_INPUT,
                             "%.200s:%d: columns are missing; expected %s",
                             reading->file, reading->line, lacking)
                   : PP_OK;
}

static enum pp_status take_header(struct csv_reading *reading, char *text,
                                  struct pp_error *err)
{
    enum pp_status status = PP_OK;
    reading->separators = strpbrk(text, ";\t") ? ";\t" : ",";
    for (char *word;
         status == PP_OK && (word = strsep(&text, reading->separators)) != NULL;) {
        if (reading->column_count == COLUMNS_MOST)
            return pp_fail(err, PP_BAD_INPUT, "%.200s:%d: more than %d columns",
                           reading->file, reading->line, COLUMNS_MOST);
        status = take_name(reading, trim(word), err);
    }
    return status == PP_OK ? check_header(reading, err) : status;
}

/* Replaces a decimal comma by a point, unless commas separate the columns. */
static void point_commas(const struct csv_reading *reading, char *word)
{
    char *comma = reading->separators[0] == ',' ? NULL : strchr(word, ',');
    if (comma)
        *comma = '.';
}

static enum pp_status take_number(struct csv_reading *reading, enum csv_column column,
                                  char *word, double of[COLUMN_KINDS],
                                  struct pp_error *err)
{
    char shown[64];
    if (column == PASSED_OVER)
        return PP_OK;
    double most = column == VALUE ? 1e9 : 1e6;
    point_commas(reading, word);
    if (!pp_text_parse_number(word, &of[column]) || fabs(of[column]) > most)
        return pp_fail(err, PP_BAD_INPUT, "%.200s:%d: found \"%s\"; expected a number",
                       reading->file, reading->line,
                       pp_text_excerpt(shown, sizeof shown, word));
    if (column == VALUE && of[column] < 0.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "%.200s:%d: the value is %g; expected 0 or more", reading->file,
                       reading->line, of[column]);
    return PP_OK;
}

static enum pp_status add_other_value(struct csv_reading *reading,
                                      const double of[COLUMN_KINDS],
                                      struct pp_error *err)
{
    struct pp_other_values *values = reading->values;
    struct pp_vec3 normal = pp_vec(of[NX], of[NY], of[NZ]);
    double length = pp_vec_length(normal);
    if (!(length > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "%.200s:%d: the direction is 0 0 0; expected at least one "
                       "number that is not 0",
                       reading->file, reading->line);
    if (values->count == POINTS_MOST)
        return pp_fail(err, PP_BAD_INPUT, "%.200s:%d: more than %d values",
                       reading->file, reading->line, POINTS_MOST);
    if (pp_array_reserve(&values->list, &reading->space, values->count + 1,
                         sizeof *values->list, err)
        != PP_OK)
        return PP_SYSTEM;
    values->list[values->count++] = (struct pp_other_value){
        pp_vec(of[X], of[Y], of[Z]), pp_vec_scale(normal, 1.0 / length), of[VALUE],
        reading->line};
    return PP_OK;
}

static enum pp_status take_row(struct csv_reading *reading, char *text,
                               struct pp_error *err)
{
    double of[COLUMN_KINDS] = {[Z] = NAN, [NZ] = 1.0};
    int count = 0;
    enum pp_status status = PP_OK;
    for (char *word;
         status == PP_OK && (word = strsep(&text, reading->separators)) != NULL;
         count++)
        if (count < reading->column_count)
            status = take_number(reading, reading->columns[count], trim(word), of, err);
    if (status == PP_OK && count != reading->column_count)
        return pp_fail(err, PP_BAD_INPUT,
                       "%.200s:%d: the line has %d fields; expected %d", reading->file,
                       reading->line, count, reading->column_count);
    return status == PP_OK ? add_other_value(reading, of, err) : status;
}

/* True if the first line is a single number, as in the output of rtrace. There is then
 * no header. */
static bool is_bare(const char *text)
{
    double value;
    return pp_text_parse_number(text, &value);
}

static enum pp_status take_csv_line(struct csv_reading *reading, char *text,
                                    struct pp_error *err)
{
    if (strlen(text) > LINE_MOST)
        return pp_fail(err, PP_BAD_INPUT,
                       "%.200s:%d: the line has %zu bytes; expected at most %d",
                       reading->file, reading->line, strlen(text), LINE_MOST);
    text += strspn(text, " \t\r");
    if (*text == '#' || *text == '\0')
        return PP_OK;
    if (reading->column_count == 0 && is_bare(text)) {
        reading->separators = ",";
        reading->columns[reading->column_count++] = VALUE;
    }
    return reading->column_count == 0 ? take_header(reading, text, err)
                                      : take_row(reading, text, err);
}

static enum pp_status read_text(struct pp_other_values *values, char *text,
                                const char *file, struct pp_error *err)
{
    struct csv_reading reading = {.file = file, .values = values};
    enum pp_status status = PP_OK;
    if (strncmp(text, "\357\273\277", 3) == 0)
        text += 3; /* skips the byte order mark of UTF-8 */
    for (char *line; status == PP_OK && (line = strsep(&text, "\n")) != NULL;) {
        reading.line++;
        status = take_csv_line(&reading, line, err);
    }
    if (status == PP_OK && values->count == 0)
        status = pp_fail(err, PP_BAD_INPUT,
                         "%.200s: there are no values; expected a header with column "
                         "names, such as x,y,df_percent, and one line per point",
                         file);
    return status;
}

enum pp_status pp_other_values_read(struct pp_other_values *values, const char *path,
                                    struct pp_error *err)
{
    char *text;
    size_t length;
    *values = (struct pp_other_values){0};
    enum pp_status status = pp_read_file(&text, &length, path, FILE_MOST, err);
    if (status != PP_OK)
        return status;
    const char *file = pp_read_file_title(path);
    if (length > FILE_MOST)
        status = pp_fail(err, PP_BAD_INPUT, "%.200s: larger than 64 MiB", file);
    else if (strlen(text) != length)
        status = pp_fail(err, PP_BAD_INPUT,
                         "%.200s: the file has a NUL byte; expected text", file);
    else
        status = read_text(values, text, file, err);
    free(text);
    if (status != PP_OK)
        pp_other_values_clear(values);
    return status;
}

void pp_other_values_clear(struct pp_other_values *values)
{
    free(values->list);
    *values = (struct pp_other_values){0};
}

/* ---- in the room ---- */

static enum pp_status place_other_value(struct pp_receiver *receiver,
                                        const struct pp_study_room *room,
                                        const struct pp_other_value *value,
                                        const char *path, struct pp_error *err)
{
    struct pp_error own = {0};
    enum pp_status status =
        pp_position_place_receiver(receiver, room->world, value->place, &own);
    const char *fault = NULL;
    if (value->normal.z < 1.0) {
        receiver->position = value->place;
        if (isnan(value->place.z))
            receiver->position.z = room->world->working_plane_m;
        receiver->normal = value->normal;
        fault = pp_position_receiver_fault(room->world, receiver->position,
                                           receiver->normal);
        status = fault ? PP_BAD_INPUT : PP_OK;
    }
    receiver->line = value->line;
    if (status == PP_OK)
        return PP_OK;
    return pp_fail(err, status, "%.200s:%d: the point %g, %g: %s",
                   pp_read_file_title(path), value->line, value->place.x,
                   value->place.y, fault ? fault : own.message);
}

int pp_other_values_spread(int point, int count, int kept)
{
    return (int)((long)point * count / kept);
}

enum pp_status pp_other_values_place(int **chosen, struct pp_study_room *room,
                                     const struct pp_other_values *values,
                                     const char *path, int most, struct pp_error *err)
{
    int count = values->count, kept = count < most ? count : most;
    if (!values->has_places && count != room->receiver_count)
        return pp_fail(err, PP_BAD_INPUT,
                       "%.200s: the %d values have no x and y; expected %d values, "
                       "one for each point of the room",
                       pp_read_file_title(path), count, room->receiver_count);
    struct pp_receiver *receivers = calloc((size_t)kept + 1, sizeof *receivers);
    *chosen = calloc((size_t)kept + 1, sizeof **chosen);
    enum pp_status status = receivers && *chosen ? PP_OK : pp_fail_memory(err);
    struct pp_receiver tried;
    for (int i = 0; i < count && status == PP_OK && values->has_places; i++)
        status = place_other_value(&tried, room, &values->list[i], path, err);
    for (int i = 0; i < kept && status == PP_OK; i++) {
        (*chosen)[i] = pp_other_values_spread(i, count, kept);
        if (!values->has_places)
            receivers[i] = room->receivers[(*chosen)[i]];
        else
            status = place_other_value(&receivers[i], room, &values->list[(*chosen)[i]],
                                       path, err);
    }
    if (status == PP_OK) {
        pp_study_room_set_points(room, receivers, kept);
        return PP_OK;
    }
    free(receivers);
    free(*chosen);
    *chosen = NULL;
    return status;
}
