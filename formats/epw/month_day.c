/* month_day.c - see month_day.h. */
#include "formats/epw/month_day.h"

#include <stdio.h>

static const char *const months[] = {"January",   "February", "March",    "April",
                                     "May",       "June",     "July",     "August",
                                     "September", "October",  "November", "December"};

int pp_month_day_days_of_month(int month)
{
    static const int days[] = {31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return days[month - 1];
}

const char *pp_month_day_words(char *text, size_t room, struct pp_month_day date)
{
    snprintf(text, room, "%d %s", date.day, months[date.month - 1]);
    return text;
}

/* Up to three numbers with / between them. Returns how many, 0 for anything else. */
static int split_date(const char *text, int parts[3])
{
    int count = 0;
    for (const char *p = text; count < 3;) {
        int used = 0;
        while (*p == ' ')
            p++;
        if (sscanf(p, "%4d%n", &parts[count], &used) != 1 || parts[count] < 0)
            return 0;
        count++;
        p += used;
        while (*p == ' ')
            p++;
        if (*p == '\0')
            return count;
        if (*p++ != '/')
            return 0;
    }
    return 0;
}

bool pp_month_day_parse_dated(const char *text, struct pp_month_day *date, int *year)
{
    int parts[3];
    int count = split_date(text, parts);
    if (count < 2)
        return false;
    bool year_first = count == 3 && parts[0] > 31;
    *date = (struct pp_month_day){parts[year_first], parts[year_first + 1]};
    *year = count < 3 ? 0 : year_first ? parts[0] : parts[2];
    return date->month >= 1 && date->month <= 12 && date->day >= 1
           && date->day <= pp_month_day_days_of_month(date->month);
}

bool pp_month_day_parse(const char *text, struct pp_month_day *date)
{
    struct pp_month_day read;
    int year;
    if (!pp_month_day_parse_dated(text, &read, &year) || year != 0)
        return false;
    *date = read;
    return true;
}

bool pp_month_day_same(struct pp_month_day a, struct pp_month_day b)
{
    return a.month == b.month && a.day == b.day;
}

bool pp_month_day_is_before(struct pp_month_day a, struct pp_month_day b)
{
    return a.month < b.month || (a.month == b.month && a.day < b.day);
}
