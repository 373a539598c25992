/* month_day.h - a day of any year, as written in weather files and options. */
#ifndef PP_FORMATS_EPW_MONTH_DAY_H
#define PP_FORMATS_EPW_MONTH_DAY_H

#include <stdbool.h>
#include <stddef.h>

/* A day of the year; month 0: no day. */
struct pp_month_day {
    int month, day; /* from 1 */
};

/* Reads "3/26" or "03/26"; false unless that day exists in some year. */
bool pp_month_day_parse(const char *text, struct pp_month_day *date);

/* Reads "M/D", "M/D/YEAR", "YEAR/M/D", or "21-Jun" as written by spreadsheets; *year is
 * 0 if there is none. */
bool pp_month_day_parse_dated(const char *text, struct pp_month_day *date, int *year);

/* Reads "2nd Sunday in March" or "Last Sunday in April", as a date of the given
 * year. */
bool pp_month_day_parse_words(const char *text, int year, struct pp_month_day *date);

/* "26 March". Returns text. */
const char *pp_month_day_words(char *text, size_t room, struct pp_month_day date);

/* Number of days of a month, 1 to 12; 29 for February. */
int pp_month_day_days_of_month(int month);

/* True if the year has a 29 February, in the Gregorian calendar. */
bool pp_month_day_is_leap(int year);

bool pp_month_day_same(struct pp_month_day a, struct pp_month_day b);

/* True if a comes before b in the year. */
bool pp_month_day_is_before(struct pp_month_day a, struct pp_month_day b);

#endif
