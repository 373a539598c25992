/* sensor_points.c - reads sensor points, a line each. */
#include "cli/radiance/sensor_points.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/read_file.h"
#include "model/base/text.h"
#include "model/base/array.h"

static const size_t FILE_MOST = (size_t)64 << 20;
enum { POINTS_MOST = 100000 };

/* Six numbers of a line, which is changed; how many words there are. */
static int read_numbers(char *line, double numbers[6])
{
    int count = 0;
    for (char *rest = line, *word; (word = strsep(&rest, " \t\r,")) != NULL;) {
        if (*word == '\0')
            continue;
        if (count == 6 || !pp_text_parse_number(word, &numbers[count])
            || fabs(numbers[count]) > 1e9)
            return -1;
        count++;
    }
    return count;
}

static enum pp_status take_sensor_line(struct pp_sensor **list, int *count, int *space,
                                       char *text, const char *file, int line,
                                       struct pp_error *err)
{
    double n[6];
    text += strspn(text, " \t\r");
    if (*text == '#' || *text == '\0')
        return PP_OK;
    int words = read_numbers(text, n);
    if (words != 6)
        return pp_fail(err, PP_BAD_INPUT,
                       "%.200s:%d: expected six numbers, x y z dx dy dz", file, line);
    struct pp_vec3 normal = pp_vec(n[3], n[4], n[5]);
    double length = pp_vec_length(normal);
    if (!(length > 0.0))
        return pp_fail(err, PP_BAD_INPUT, "%.200s:%d: a direction of 0 0 0", file,
                       line);
    if (*count == POINTS_MOST)
        return pp_fail(err, PP_BAD_INPUT, "%.200s:%d: more than %d points", file, line,
                       POINTS_MOST);
    if (pp_array_reserve(list, space, *count + 1, sizeof **list, err) != PP_OK)
        return PP_SYSTEM;
    (*list)[(*count)++] = (struct pp_sensor){pp_vec(n[0], n[1], n[2]),
                                             pp_vec_scale(normal, 1.0 / length), line};
    return PP_OK;
}

enum pp_status pp_sensor_points_read(struct pp_sensor **list, int *count,
                                     const char *path, struct pp_error *err)
{
    char *bytes;
    size_t length;
    *list = NULL;
    *count = 0;
    enum pp_status status = pp_read_file(&bytes, &length, path, FILE_MOST, err);
    if (status != PP_OK)
        return status;
    const char *file = pp_read_file_title(path);
    char *ended = realloc(bytes, length + 1);
    if (!ended) {
        free(bytes);
        return pp_fail_memory(err);
    }
    ended[length] = '\0';
    if (strlen(ended) != length)
        status = pp_fail(err, PP_BAD_INPUT,
                         "%.200s: a character of code 0; expected text", file);
    int space = 0, line = 1;
    for (char *rest = ended, *text; status == PP_OK && (text = strsep(&rest, "\n"));)
        status = take_sensor_line(list, count, &space, text, file, line++, err);
    if (status == PP_OK && *count == 0)
        status = pp_fail(err, PP_BAD_INPUT,
                         "%.200s: no points; expected lines of x y z dx dy dz", file);
    free(ended);
    if (status != PP_OK) {
        free(*list);
        *list = NULL;
        *count = 0;
    }
    return status;
}
