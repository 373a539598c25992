/* picture_format.c - list of the numeric formats, followed by the formats of charts. */
#include "cli/render/picture_format.h"

#include <string.h>
#include <strings.h>

#include "model/base/text.h"

static const struct {
    const char *extension;
    enum pp_chart_format format;
} shown[] = {{"png", PP_CHART_PNG}, {"pdf", PP_CHART_PDF}, {"svg", PP_CHART_SVG}};

enum { SHOWN_COUNT = sizeof shown / sizeof *shown };

static int number_count(void)
{
    int count = 0;
    while (pp_number_format_at(count))
        count++;
    return count;
}

static struct pp_picture_format format_at(int index, const char **extension)
{
    int numbers = number_count();
    struct pp_picture_format format = {0};
    if (index < numbers) {
        format.numbers = pp_number_format_at(index);
        *extension = format.numbers->extension;
    } else {
        format.shown = shown[index - numbers].format;
        *extension = shown[index - numbers].extension;
    }
    return format;
}

bool pp_picture_format_named(struct pp_picture_format *format, const char *name)
{
    const char *extension;
    for (int i = 0; i < number_count() + SHOWN_COUNT; i++) {
        *format = format_at(i, &extension);
        if (strcmp(name, extension) == 0)
            return true;
    }
    return false;
}

bool pp_picture_format_of(struct pp_picture_format *format, const char *path)
{
    const char *point = strrchr(path, '.');
    *format = (struct pp_picture_format){0};
    if (!point)
        return false;
    format->numbers = pp_number_format_find(point + 1);
    for (int i = 0; i < SHOWN_COUNT && !format->numbers; i++)
        if (strcasecmp(point + 1, shown[i].extension) == 0) {
            format->shown = shown[i].format;
            return true;
        }
    return format->numbers != NULL;
}

const char *pp_picture_format_list(char *text, size_t size, const char *before,
                                   bool numbers_only)
{
    int count = number_count() + (numbers_only ? 0 : SHOWN_COUNT);
    text[0] = '\0';
    for (int i = 0; i < count; i++) {
        const char *extension;
        format_at(i, &extension);
        pp_text_append(text, size, "%s%s%s",
                       i == 0          ? ""
                       : i + 1 < count ? ", "
                                       : " or ",
                       before, extension);
    }
    return text;
}
