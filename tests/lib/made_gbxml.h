/* made_gbxml.h - builds gbXML files for tests, and imports them as room files. */
#ifndef PP_TESTS_LIB_MADE_GBXML_H
#define PP_TESTS_LIB_MADE_GBXML_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/gbxml/gbxml_import.h"
#include "tests/lib/near.h"

/* A gbXML file under construction; lengths are given in metres and written in the
 * file's unit. */
struct made_gbxml {
    char *text;
    size_t length;
    FILE *out;
    double metre;       /* metres per unit */
    double east, north; /* position of the model's origin, metres */
};

/* The struct must not move, since the stream refers to it. */
static inline void made_gbxml_begin(struct made_gbxml *file, const char *unit,
                                    double metre, const char *location)
{
    *file = (struct made_gbxml){.metre = metre};
    file->out = open_memstream(&file->text, &file->length);
    fprintf(file->out,
            "<?xml version=\"1.0\"?>\n<gbXML lengthUnit=\"%s\" "
            "xmlns=\"http://www.gbxml.org/schema\">\n<Campus id=\"c\">\n<Location>%s"
            "</Location>\n<Building id=\"b\"><Name>House</Name>\n",
            unit, location);
}

static inline void made_gbxml_loop(struct made_gbxml *file, int count,
                                   const double *corners)
{
    fputs("<PolyLoop>", file->out);
    for (int i = 0; i < count; i++)
        fprintf(file->out,
                "<CartesianPoint><Coordinate>%.9f</Coordinate><Coordinate>%.9f"
                "</Coordinate><Coordinate>%.9f</Coordinate></CartesianPoint>",
                (corners[3 * i] + file->east) / file->metre,
                (corners[3 * i + 1] + file->north) / file->metre,
                corners[3 * i + 2] / file->metre);
    fputs("</PolyLoop>\n", file->out);
}

static inline void made_gbxml_geometry(struct made_gbxml *file, int count,
                                       const double *corners)
{
    fputs("<PlanarGeometry>", file->out);
    made_gbxml_loop(file, count, corners);
    fputs("</PlanarGeometry>", file->out);
}

/* Begins a surface; its openings follow, then made_gbxml_end_surface. space, other: the
 * spaces on its two sides; NULL: none. */
static inline void made_gbxml_surface(struct made_gbxml *file, const char *type,
                                      const char *space, const char *other, int count,
                                      const double *corners)
{
    fprintf(file->out,
            "<Surface id=\"s%ld\" surfaceType=\"%s\" constructionIdRef=\"k\">",
            ftell(file->out), type);
    if (space)
        fprintf(file->out, "<AdjacentSpaceId spaceIdRef=\"%s\"/>", space);
    if (other)
        fprintf(file->out, "<AdjacentSpaceId spaceIdRef=\"%s\"/>", other);
    made_gbxml_geometry(file, count, corners);
}

static inline void made_gbxml_opening(struct made_gbxml *file, const char *type,
                                      int count, const double *corners)
{
    fprintf(file->out, "<Opening id=\"o\" openingType=\"%s\" windowTypeIdRef=\"w\">",
            type);
    made_gbxml_geometry(file, count, corners);
    fputs("</Opening>", file->out);
}

static inline void made_gbxml_end_surface(struct made_gbxml *file)
{
    fputs("</Surface>\n", file->out);
}

#define CORNERS(...)                                                                   \
    (int)(sizeof((double[]){__VA_ARGS__}) / sizeof(double) / 3), (const double[])      \
    {                                                                                  \
        __VA_ARGS__                                                                    \
    }

/* Writes the six sides of a box from (x, 0, 0), except those left out; a window of 1.6
 * x 1.2 m is in the south wall. */
enum { NO_EAST = 1, NO_WEST = 2, NO_ROOF = 4 };

static inline void made_gbxml_box(struct made_gbxml *f, const char *space, double x,
                                  double w, double d, double h, int without)
{
    made_gbxml_surface(f, "SlabOnGrade", space, NULL,
                       CORNERS(x, 0, 0, x, d, 0, x + w, d, 0, x + w, 0, 0));
    made_gbxml_end_surface(f);
    if (!(without & NO_ROOF)) {
        made_gbxml_surface(f, "Roof", space, NULL,
                           CORNERS(x, 0, h, x + w, 0, h, x + w, d, h, x, d, h));
        made_gbxml_end_surface(f);
    }
    made_gbxml_surface(f, "ExteriorWall", space, NULL,
                       CORNERS(x, 0, 0, x + w, 0, 0, x + w, 0, h, x, 0, h));
    made_gbxml_opening(
        f, "OperableWindow",
        CORNERS(x + 1, 0, 0.9, x + 2.6, 0, 0.9, x + 2.6, 0, 2.1, x + 1, 0, 2.1));
    made_gbxml_end_surface(f);
    made_gbxml_surface(f, "ExteriorWall", space, NULL,
                       CORNERS(x + w, d, 0, x, d, 0, x, d, h, x + w, d, h));
    made_gbxml_end_surface(f);
    if (!(without & NO_EAST)) {
        made_gbxml_surface(f, "ExteriorWall", space, NULL,
                           CORNERS(x + w, 0, 0, x + w, d, 0, x + w, d, h, x + w, 0, h));
        made_gbxml_end_surface(f);
    }
    if (!(without & NO_WEST)) {
        made_gbxml_surface(f, "ExteriorWall", space, NULL,
                           CORNERS(x, d, 0, x, 0, 0, x, 0, h, x, d, h));
        made_gbxml_end_surface(f);
    }
}

static inline void made_gbxml_end(struct made_gbxml *file, const char *constructions)
{
    fprintf(
        file->out,
        "</Campus>\n<Construction id=\"k\"><Reflectance unit=\"Fraction\" "
        "type=\"IntVisible\" surfaceType=\"Both\">0.55</Reflectance></Construction>\n"
        "<WindowType id=\"w\"><Transmittance unit=\"Percent\" type=\"Visible\" "
        "surfaceType=\"Both\">80</Transmittance></WindowType>%s</gbXML>\n",
        constructions);
    fclose(file->out);
}

static inline void made_gbxml_space(struct made_gbxml *file, const char *id,
                                    const char *type)
{
    fprintf(file->out,
            "<Space id=\"%s\" spaceType=\"%s\"><Name>Room %s</Name></Space>\n", id,
            type, id);
}

/* Imports the file and frees its text; `notes` (may be NULL, of `room` bytes) gets the
 * notes, one per line. Not inlined, since gcc 12 then warns of a dangling pointer where
 * there is none. */
static char *__attribute__((noinline, unused))
made_gbxml_import(struct made_gbxml *file, char *notes, size_t room)
{
    struct pp_mistakes said;
    struct pp_error err = {0};
    char *xml = NULL;
    size_t length;
    pp_mistakes_init(&said, "test.xml");
    enum pp_status status = pp_gbxml_import(&xml, &length, file->text, file->length,
                                            "test.xml", &said, &err);
    if (notes)
        *notes = '\0';
    for (int i = 0; notes && i < said.count; i++)
        snprintf(notes + strlen(notes), room - strlen(notes), "%s\n",
                 said.list[i].text);
    pp_mistakes_clear(&said);
    free(file->text);
    if (status != PP_OK)
        fail_msg("%s", err.message);
    return xml;
}

#endif
