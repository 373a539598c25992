/* text.c - see text.h. */
#include "model/base/text.h"

#include <stdio.h>
#include <string.h>

void pp_append_v(char *text, size_t room, const char *format, va_list arguments)
{
    size_t length = strlen(text);
    vsnprintf(text + length, room - length, format, arguments);
}

void pp_append(char *text, size_t room, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    pp_append_v(text, room, format, arguments);
    va_end(arguments);
}

void pp_append_list(char *text, size_t room, const char *const *names, int count,
                    const char *last)
{
    if (count < 0)
        for (count = 0; names[count];)
            count++;
    for (int i = 0; i < count; i++)
        pp_append(text, room, "%s%s",
                  i == 0           ? ""
                  : i + 1 == count ? last
                                   : ", ",
                  names[i]);
}
