/* number_format.c - the list of the formats that keep a picture's numbers: a line each.
 */
#include "formats/pictures/number_format.h"

#include <stddef.h>
#include <strings.h>

static const struct pp_number_format *const formats[] = {
    &pp_number_format_hdr,
    &pp_number_format_pfm,
    NULL,
};

const struct pp_number_format *pp_number_format_at(int index)
{
    return formats[index];
}

const struct pp_number_format *pp_number_format_find(const char *ending)
{
    for (int i = 0; formats[i]; i++)
        if (strcasecmp(formats[i]->ending, ending) == 0
            || (formats[i]->other_ending
                && strcasecmp(formats[i]->other_ending, ending) == 0))
            return formats[i];
    return NULL;
}
