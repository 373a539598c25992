/* month_day.c - see month_day.h. */
#include "formats/epw/month_day.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

static const char *const months[] = {"January",   "February", "March",    "April",
                                     "May",       "June",     "July",     "August",
                                     "September", "October",  "November", "December"};

bool pp_month_day_is_leap(int year)
{
    return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
}

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

/* Reads up to three numbers separated by "/". Returns their number, 0 for other
 * text. */
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

/* The month, 1 to 12, whose name or first three letters begin the text; 0 if none.
 * *length is the number of letters. */
static int find_month(const char *text, int *length)
{
    for (int i = 0; i < 12; i++) {
        *length = (int)strlen(months[i]);
        if (strncasecmp(text, months[i], (size_t)*length) == 0)
            return i + 1;
        *length = 3;
        if (strncasecmp(text, months[i], 3) == 0)
            return i + 1;
    }
    return 0;
}

/* Reads a day and a month's name separated by "-". */
static bool split_named(const char *text, int parts[3])
{
    int used = 0, length;
    if (sscanf(text, "%2d-%n", &parts[1], &used) != 1 || used == 0 || parts[1] < 1)
        return false;
    parts[0] = find_month(text + used, &length);
    return parts[0] > 0 && text[used + length] == '\0';
}

bool pp_month_day_parse_dated(const char *text, struct pp_month_day *date, int *year)
{
    int parts[3];
    int count = split_named(text, parts) ? 2 : split_date(text, parts);
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

/* Day of the week, 0 Monday to 6 Sunday, by the Gregorian calendar. */
static int weekday_of(int year, int month, int day)
{
    static const int shifts[] = {0, 3, 2, 5, 0, 3, 5, 1, 4, 6, 2, 4};
    year -= month < 3;
    return (year + year / 4 - year / 100 + year / 400 + shifts[month - 1] + day + 6)
           % 7;
}

bool pp_month_day_parse_words(const char *text, int year, struct pp_month_day *date)
{
    static const char *const days[] = {"monday", "tuesday",  "wednesday", "thursday",
                                       "friday", "saturday", "sunday"};
    char which[8], day[12], month[12];
    int weekday = 0, length, nth = 0, used = 0;
    if (sscanf(text, " %7s %11s %*[inIN] %11s %n", which, day, month, &used) != 3
        || used == 0 || text[used] != '\0')
        return false;
    while (weekday < 7 && strcasecmp(day, days[weekday]) != 0)
        weekday++;
    date->month = find_month(month, &length);
    if (strcasecmp(which, "last") != 0 && (sscanf(which, "%1d", &nth) != 1 || nth < 1))
        return false;
    if (weekday == 7 || date->month == 0 || month[length] != '\0' || nth > 4)
        return false;
    int most = pp_month_day_days_of_month(date->month);
    if (date->month == 2 && !pp_month_day_is_leap(year))
        most = 28;
    if (nth > 0)
        date->day = 7 * nth - 6 + (weekday - weekday_of(year, date->month, 1) + 7) % 7;
    else
        date->day = most - (weekday_of(year, date->month, most) - weekday + 7) % 7;
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
