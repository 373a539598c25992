/* rooms_table.c - see rooms_table.h. */
#include "reports/page/rooms_table.h"

#include <math.h>

#include "methods/allowance.h"
#include "reports/page/room_chapter.h"

/* Area-weighted mean reflectance of the faces with this role; NAN: there are none. */
static double reflectance_of(const struct pp_world *world, enum pp_role role)
{
    double area = 0.0, sum = 0.0;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        if (face->role != role)
            continue;
        area += face->outline.area_m2;
        sum += face->outline.area_m2 * face->front;
    }
    return sum / area;
}

static double glass_m2(const struct pp_world *world)
{
    double area = 0.0;
    for (int i = 0; i < world->opening_count; i++)
        area += pp_allowance_net_glass_m2(&world->openings[i]);
    return area;
}

/* Last simulated average daylight factor, or else the average by the first hand method
 * that has one; NAN: none. */
static double average_of(const struct pp_report *report)
{
    double average = NAN;
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (column->component == PP_DF && isfinite(column->average.value)
            && (isnan(average) || isfinite(column->average.std_error)))
            average = column->average.value;
    }
    return average;
}

void pp_rooms_table(struct pp_document *document, const struct pp_assessments *all)
{
    static const struct {
        enum pp_document_column_kind kind;
        const char *heading;
    } heads[] = {
        {PP_COLUMN_WORDS, "room"},        {PP_COLUMN_WORDS, "ref"},
        {PP_COLUMN_WORDS, "use"},         {PP_COLUMN_NUMBERS, "floor, m²"},
        {PP_COLUMN_NUMBERS, "height, m"}, {PP_COLUMN_NUMBERS, "glass, m²"},
        {PP_COLUMN_NUMBERS, "floor ρ"},   {PP_COLUMN_NUMBERS, "walls ρ"},
        {PP_COLUMN_NUMBERS, "ceiling ρ"}, {PP_COLUMN_NUMBERS, "average DF, %"},
    };
    pp_document_table(document);
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++)
        pp_document_column(document, heads[i].kind, "%s", heads[i].heading);
    for (int i = 0; i < all->count; i++) {
        const struct pp_world *world = all->list[i].room->world;
        pp_document_row(document, PP_ROW_CELLS);
        pp_document_cell(document, PP_TONE_PLAIN, "%s", world->name ? world->name : "");
        pp_document_cell(document, PP_TONE_PLAIN, "%s", world->ref ? world->ref : "");
        pp_document_cell(document, PP_TONE_PLAIN, "%s",
                         world->use ? pp_room_use_words[world->use] : "");
        pp_room_chapter_number(document, pp_world_floor_m2(world), 1);
        pp_room_chapter_number(document, world->height_m, 2);
        pp_room_chapter_number(document, glass_m2(world), 2);
        pp_room_chapter_number(document, reflectance_of(world, PP_FLOOR), 2);
        pp_room_chapter_number(document, reflectance_of(world, PP_WALL), 2);
        pp_room_chapter_number(document, reflectance_of(world, PP_CEILING), 2);
        pp_room_chapter_number(document, 100.0 * average_of(&all->list[i].report), 2);
    }
    pp_document_paragraph(document, PP_TONE_SOFT,
                          "ρ: mean reflectance; glass: area of the openings without "
                          "frames; DF: daylight factor.");
}
