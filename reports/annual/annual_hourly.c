/* annual_hourly.c - see annual_hourly.h. */
#include "reports/annual/annual_hourly.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "reports/parts/json.h"

enum pp_annual_hourly_format pp_annual_hourly_of_name(const char *name)
{
    static const struct {
        const char *end;
        enum pp_annual_hourly_format format;
    } ends[] = {{".csv", PP_ANNUAL_HOURLY_CSV},
                {".ill", PP_ANNUAL_HOURLY_ILL},
                {".npy", PP_ANNUAL_HOURLY_NPY}};
    size_t length = strlen(name);
    if (strcmp(name, "json") == 0)
        return PP_ANNUAL_HOURLY_JSON;
    for (int i = 0; i < 3; i++)
        if (length > 4 && strcasecmp(name + length - 4, ends[i].end) == 0)
            return ends[i].format;
    return PP_ANNUAL_HOURLY_NONE;
}

static void put_csv(const struct pp_annual_sheet *sheet, FILE *out)
{
    fputs("month,day,hour_middle,sun_altitude_deg,sun_bearing_deg,"
          "diffuse_horizontal_lx,direct_normal_lx,occupied_h",
          out);
    for (int x = 0; x < sheet->receiver_count; x++)
        fprintf(out, ",E%d", x + 1);
    fputs("\r\n", out);
    for (int i = 0; i < sheet->hour_count; i++) {
        const struct pp_annual_hour *hour = &sheet->hours[i];
        fprintf(out, "%d,%d,%g", hour->month, hour->day,
                hour->start_h + 0.5 * hour->length_h);
        if (hour->sky >= 0)
            fprintf(out, ",%.4f,%.4f,%.1f,%.1f", hour->sun_altitude_rad / PP_RAD,
                    hour->sun_bearing_rad / PP_RAD, hour->diffuse_lx, hour->direct_lx);
        else
            fputs(hour->known ? ",,,0,0" : ",,,,", out);
        fprintf(out, ",%g", hour->occupied_h);
        for (int x = 0; x < sheet->receiver_count; x++) {
            double lx = pp_annual_sheet_lx(sheet, x, i);
            if (isnan(lx))
                fputc(',', out);
            else
                fprintf(out, ",%.2f", lx);
        }
        fputs("\r\n", out);
    }
}

static void put_ill(const struct pp_annual_sheet *sheet, FILE *out)
{
    for (int i = 0; i < sheet->hour_count; i++) {
        const struct pp_annual_hour *hour = &sheet->hours[i];
        fprintf(out, "%d %d %.3f", hour->month, hour->day,
                hour->start_h + 0.5 * hour->length_h);
        for (int x = 0; x < sheet->receiver_count; x++) {
            double lx = pp_annual_sheet_lx(sheet, x, i);
            fprintf(out, " %.0f", isnan(lx) ? 0.0 : lx);
        }
        fputc('\n', out);
    }
}

/* Writes version 1.0 of NumPy's file format: a header of 128 bytes, then little-endian
 * numbers. */
static void put_npy(const struct pp_annual_sheet *sheet, FILE *out)
{
    enum { HEADER = 128, PREFIX = 10 };
    char header[HEADER + 1];
    memset(header, ' ', sizeof header);
    memcpy(header, "\x93NUMPY\x01\x00\x76\x00", PREFIX);
    int used = snprintf(header + PREFIX, HEADER - PREFIX,
                        "{'descr': '<f4', 'fortran_order': False, 'shape': (%d, %d), }",
                        sheet->receiver_count, sheet->hour_count);
    header[PREFIX + used] = ' ';
    header[HEADER - 1] = '\n';
    fwrite(header, 1, HEADER, out);
    for (int x = 0; x < sheet->receiver_count; x++)
        for (int i = 0; i < sheet->hour_count; i++) {
            float lx = (float)pp_annual_sheet_lx(sheet, x, i);
            uint32_t bits;
            memcpy(&bits, &lx, sizeof bits);
            for (int k = 0; k < 4; k++)
                fputc((int)(bits >> 8 * k & 0xFF), out);
        }
}

void pp_annual_hourly_put(const struct pp_annual_sheet *sheet,
                          enum pp_annual_hourly_format format, FILE *out)
{
    switch (format) {
    case PP_ANNUAL_HOURLY_CSV:
        put_csv(sheet, out);
        break;
    case PP_ANNUAL_HOURLY_ILL:
        put_ill(sheet, out);
        break;
    case PP_ANNUAL_HOURLY_NPY:
        put_npy(sheet, out);
        break;
    case PP_ANNUAL_HOURLY_JSON:
    case PP_ANNUAL_HOURLY_NONE:
        break;
    }
}

static double rounded_lx(double lx)
{
    return floor(10.0 * lx + 0.5) / 10.0;
}

/* Fills in the illuminances (lx, to one decimal) of all hours at a point. -1: the mean
 * of all points. */
static void fill_lx(double *values, const struct pp_annual_sheet *sheet, int point)
{
    int first = point < 0 ? 0 : point;
    int count = point < 0 ? sheet->receiver_count : 1;
    for (int i = 0; i < sheet->hour_count; i++) {
        double sum = 0.0;
        for (int x = first; x < first + count; x++)
            sum += pp_annual_sheet_lx(sheet, x, i);
        values[i] = rounded_lx(sum / count);
    }
}

static void fill_dates(double *months, double *days, double *middles, double *occupied,
                       const struct pp_annual_sheet *sheet)
{
    for (int i = 0; i < sheet->hour_count; i++) {
        const struct pp_annual_hour *hour = &sheet->hours[i];
        months[i] = hour->month;
        days[i] = hour->day;
        middles[i] = hour->start_h + 0.5 * hour->length_h;
        occupied[i] = hour->occupied_h;
    }
}

bool pp_annual_hourly_add_json(struct json_object *object,
                               const struct pp_annual_sheet *sheet)
{
    int count = sheet->hour_count;
    size_t hours = (size_t)count;
    double *values = calloc(4 * hours + 1, sizeof *values);
    struct json_object *to = json_object_new_object(), *points;
    bool good = pp_json_add(object, "hourly", to) && values;
    if (good)
        fill_dates(values, values + hours, values + 2 * hours, values + 3 * hours,
                   sheet);
    good = good && pp_json_numbers(to, "month", values, count)
           && pp_json_numbers(to, "day", values + hours, count)
           && pp_json_numbers(to, "hour_middle", values + 2 * hours, count)
           && pp_json_numbers(to, "occupied_h", values + 3 * hours, count);
    if (good) {
        fill_lx(values, sheet, -1);
        points = json_object_new_array();
        good = pp_json_numbers(to, "average_lux", values, count)
               && pp_json_add(to, "points", points);
    }
    for (int x = 0; x < sheet->receiver_count && good
                    && sheet->receiver_count <= PP_ANNUAL_HOURLY_JSON_POINTS;
         x++) {
        struct json_object *point = json_object_new_object();
        fill_lx(values, sheet, x);
        good = pp_json_append(points, point)
               && pp_json_numbers(point, "lux", values, count);
    }
    free(values);
    return good;
}

void pp_annual_hourly_put_matrix(const struct pp_annual_sheet *sheet, FILE *out)
{
    int columns = 1 + sheet->patch_count;
    fprintf(out,
            "#?RADIANCE\npepperpot annual --coefficients\n%sNROWS=%d\nNCOLS=%d\n"
            "NCOMP=3\nFORMAT=ascii\n\n",
            sheet->coefficient_record, sheet->receiver_count, columns);
    for (int x = 0; x < sheet->receiver_count; x++) {
        for (int k = 0; k < columns; k++) {
            double lx = sheet->coefficients[(size_t)x * (size_t)columns + (size_t)k];
            fprintf(out, "%s%.6g %.6g %.6g", k > 0 ? "\t" : "", lx, lx, lx);
        }
        fputc('\n', out);
    }
}
