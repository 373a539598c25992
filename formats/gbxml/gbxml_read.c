/* gbxml_read.c - the elements of gbXML, one by one. */
#include "formats/gbxml/gbxml_read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

/* Most corners, surfaces and spaces that are read. */
enum { CORNERS_MOST = 1000, SURFACES_MOST = 100000, SPACES_MOST = 10000 };

/* Most that a coordinate may be, as in a room file. */
static const double farthest_m = 1e5;

struct gbxml_named;

struct gbxml_reader {
    struct pp_gbxml_model *model;
    const struct pp_xml_element *root;
    double metre; /* metres of a unit of the file's lengths */
    struct gbxml_named *named;
    int named_count;
    int between, without_type; /* openings between spaces, and without a window type */
    const char *file;
    struct pp_mistakes *notes;
    struct pp_error *err;
};

static enum pp_status read_unit(struct gbxml_reader *r)
{
    static const struct {
        const char *name;
        double metre;
    } units[] = {{"Kilometers", 1e3},   {"Meters", 1.0},     {"Centimeters", 0.01},
                 {"Millimeters", 1e-3}, {"Miles", 1609.344}, {"Yards", 0.9144},
                 {"Feet", 0.3048},      {"Inches", 0.0254}};
    const char *typed = pp_gbxml_document_attribute(r->root, "lengthUnit");
    for (int i = 0; typed && i < (int)(sizeof units / sizeof *units); i++)
        if (strcmp(typed, units[i].name) == 0) {
            r->metre = units[i].metre;
            return PP_OK;
        }
    return pp_fail(
        r->err, PP_BAD_INPUT,
        "%s:%d: lengthUnit is \"%.40s\"; expected Meters, Feet, Millimeters, "
        "Inches or another of gbXML's",
        r->file, r->root->line, typed ? typed : "");
}

/* ---- polygons ---- */

static bool read_corner(const struct gbxml_reader *r,
                        const struct pp_xml_element *point, struct pp_vec3 *corner)
{
    double xyz[3];
    const struct pp_xml_element *coordinate =
        pp_gbxml_document_child(point, "Coordinate");
    for (int i = 0; i < 3; i++) {
        if (!coordinate || !pp_gbxml_document_number(coordinate, &xyz[i]))
            return false;
        xyz[i] *= r->metre;
        if (!(fabs(xyz[i]) <= farthest_m))
            return false;
        coordinate = pp_gbxml_document_next(coordinate, "Coordinate");
    }
    *corner = (struct pp_vec3){xyz[0], xyz[1], xyz[2]};
    return true;
}

/* Reads a PolyLoop; false, with a note, if it is none. */
static bool read_loop(struct gbxml_reader *r, const struct pp_xml_element *loop,
                      struct pp_gbxml_polygon *polygon)
{
    *polygon = (struct pp_gbxml_polygon){0};
    for (const struct pp_xml_element *point =
             pp_gbxml_document_child(loop, "CartesianPoint");
         point; point = pp_gbxml_document_next(point, "CartesianPoint")) {
        struct pp_vec3 corner;
        if (polygon->count == CORNERS_MOST || !read_corner(r, point, &corner)
            || pp_array_append(&polygon->corners, polygon->count,
                               sizeof *polygon->corners, r->err)
                   != PP_OK) {
            pp_mistakes_add(
                r->notes, point->line,
                "no corner of three coordinates within 100 km, of a polygon "
                "of %d at most: the polygon is left out",
                CORNERS_MOST);
            break;
        }
        polygon->corners[polygon->count++] = corner;
        if (!pp_gbxml_document_next(point, "CartesianPoint") && polygon->count >= 3)
            return true;
    }
    free(polygon->corners);
    *polygon = (struct pp_gbxml_polygon){0};
    return false;
}

static bool read_outline(struct gbxml_reader *r, const struct pp_xml_element *element,
                         struct pp_gbxml_polygon *polygon)
{
    const struct pp_xml_element *loop =
        pp_gbxml_document_path(element, "PlanarGeometry/PolyLoop");
    if (loop)
        return read_loop(r, loop, polygon);
    pp_mistakes_add(r->notes, element->line,
                    "%s \"%.60s\" has no PlanarGeometry; left out", element->name,
                    pp_gbxml_document_attribute(element, "id"));
    return false;
}

/* ---- light ---- */

/* A construction or window type by its id. */
struct gbxml_named {
    const char *name, *id;
    const struct pp_xml_element *element;
};

static int by_name(const void *a, const void *b)
{
    const struct gbxml_named *one = a, *other = b;
    int names = strcmp(one->name, other->name);
    return names ? names : strcmp(one->id, other->id);
}

/* Lists all of them, in order. */
static enum pp_status list_named(struct gbxml_reader *r)
{
    static const char *const names[] = {"Construction", "WindowType"};
    for (int i = 0; i < 2; i++)
        for (const struct pp_xml_element *at =
                 pp_gbxml_document_child(r->root, names[i]);
             at; at = pp_gbxml_document_next(at, names[i])) {
            const char *id = pp_gbxml_document_attribute(at, "id");
            if (!id)
                continue;
            enum pp_status status =
                pp_array_append(&r->named, r->named_count, sizeof *r->named, r->err);
            if (status != PP_OK)
                return status;
            r->named[r->named_count++] = (struct gbxml_named){names[i], id, at};
        }
    if (r->named_count > 0)
        qsort(r->named, (size_t)r->named_count, sizeof *r->named, by_name);
    return PP_OK;
}

/* The one of that name and id; NULL: none. */
static const struct pp_xml_element *find_by_id(const struct gbxml_reader *r,
                                               const char *name, const char *id)
{
    const struct gbxml_named wanted = {name, id ? id : "", NULL};
    const struct gbxml_named *found =
        r->named_count > 0 ? bsearch(&wanted, r->named, (size_t)r->named_count,
                                     sizeof *r->named, by_name)
                           : NULL;
    return found ? found->element : NULL;
}

/* The share of that name and type ("IntVisible") in an element: fraction or per cent. NAN:
 * none, or none that is a share. */
static double read_share(const struct pp_xml_element *element, const char *name,
                         const char *type)
{
    for (const struct pp_xml_element *at = pp_gbxml_document_child(element, name); at;
         at = pp_gbxml_document_next(at, name)) {
        const char *of = pp_gbxml_document_attribute(at, "type");
        const char *unit = pp_gbxml_document_attribute(at, "unit");
        double share;
        if (!of || strcmp(of, type) != 0 || !pp_gbxml_document_number(at, &share))
            continue;
        if (unit && strcmp(unit, "Percent") == 0)
            share /= 100.0;
        if (share >= 0.0 && share <= 1.0)
            return share;
    }
    return NAN;
}

static double read_transmittance(struct gbxml_reader *r,
                                 const struct pp_xml_element *opening)
{
    static const char *const refs[] = {"windowTypeIdRef", "constructionIdRef"};
    static const char *const names[] = {"WindowType", "Construction"};
    const struct pp_xml_element *found = NULL;
    for (int i = 0; i < 2 && !found; i++)
        found = find_by_id(r, names[i], pp_gbxml_document_attribute(opening, refs[i]));
    double share = read_share(found, "Transmittance", "Visible");
    if (share > 0.0)
        return share;
    if (found)
        pp_mistakes_add(
            r->notes, found->line,
            "%s \"%.60s\" has no visible transmittance above 0; clear-double "
            "is taken for its openings",
            found->name, pp_gbxml_document_attribute(found, "id"));
    r->without_type += !found;
    return NAN;
}

/* ---- surfaces ---- */

static bool is_one_of(const char *word, const char *const *words)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(word, words[i]) == 0)
            return true;
    return false;
}

static enum pp_status add_gbxml_opening(struct gbxml_reader *r,
                                        struct pp_gbxml_surface *surface,
                                        const struct pp_xml_element *element)
{
    static const char *const glazed[] = {"FixedWindow",   "OperableWindow",
                                         "FixedSkylight", "OperableSkylight",
                                         "SlidingDoor",   NULL};
    const char *type = pp_gbxml_document_attribute(element, "openingType");
    const char *id = pp_gbxml_document_attribute(element, "id");
    if (surface->spaces[1]) {
        r->between++;
        return PP_OK;
    }
    if (!type || !is_one_of(type, glazed)) {
        pp_mistakes_add(
            r->notes, element->line,
            "opening \"%.60s\" is of type \"%.40s\", no window, skylight or "
            "sliding door; taken as wall",
            id ? id : "", type ? type : "");
        return PP_OK;
    }
    struct pp_gbxml_opening opening = {.line = element->line, .name = id};
    if (!read_outline(r, element, &opening.outline))
        return PP_OK;
    opening.transmittance = read_transmittance(r, element);
    enum pp_status status = pp_array_append(&surface->openings, surface->opening_count,
                                            sizeof *surface->openings, r->err);
    if (status == PP_OK)
        surface->openings[surface->opening_count++] = opening;
    else
        free(opening.outline.corners);
    return status;
}

static enum pp_status add_gbxml_surface(struct gbxml_reader *r,
                                        const struct pp_xml_element *element)
{
    struct pp_gbxml_model *model = r->model;
    const char *type = pp_gbxml_document_attribute(element, "surfaceType");
    struct pp_gbxml_surface surface = {.line = element->line, .type = type ? type : ""};
    if (model->surface_count == SURFACES_MOST)
        return pp_fail(r->err, PP_BAD_INPUT,
                       "%s:%d: more than %d surfaces, the most that "
                       "are read",
                       r->file, surface.line, SURFACES_MOST);
    if (!read_outline(r, element, &surface.outline))
        return PP_OK;
    int neighbours = 0;
    for (const struct pp_xml_element *at =
             pp_gbxml_document_child(element, "AdjacentSpaceId");
         at && neighbours < PP_GBXML_NEIGHBOURS;
         at = pp_gbxml_document_next(at, "AdjacentSpaceId"))
        surface.spaces[neighbours++] = pp_gbxml_document_attribute(at, "spaceIdRef");
    const struct pp_xml_element *construction = find_by_id(
        r, "Construction", pp_gbxml_document_attribute(element, "constructionIdRef"));
    surface.reflectance = read_share(construction, "Reflectance", "IntVisible");
    enum pp_status status = pp_array_append(&model->surfaces, model->surface_count,
                                            sizeof *model->surfaces, r->err);
    if (status != PP_OK) {
        free(surface.outline.corners);
        return status;
    }
    struct pp_gbxml_surface *placed = &model->surfaces[model->surface_count++];
    *placed = surface;
    for (const struct pp_xml_element *at = pp_gbxml_document_child(element, "Opening");
         at && status == PP_OK; at = pp_gbxml_document_next(at, "Opening"))
        status = add_gbxml_opening(r, placed, at);
    return status;
}

/* ---- spaces ---- */

static enum pp_status add_shell(struct gbxml_reader *r, struct pp_gbxml_space *space,
                                const struct pp_xml_element *element)
{
    enum pp_status status = PP_OK;
    const struct pp_xml_element *shell =
        pp_gbxml_document_path(element, "ShellGeometry/ClosedShell");
    for (const struct pp_xml_element *loop = pp_gbxml_document_child(shell, "PolyLoop");
         loop && status == PP_OK; loop = pp_gbxml_document_next(loop, "PolyLoop")) {
        struct pp_gbxml_polygon polygon;
        if (!read_loop(r, loop, &polygon))
            continue;
        status = pp_array_append(&space->shell, space->shell_count,
                                 sizeof *space->shell, r->err);
        if (status == PP_OK)
            space->shell[space->shell_count++] = polygon;
        else
            free(polygon.corners);
    }
    return status;
}

static enum pp_status add_space(struct gbxml_reader *r,
                                const struct pp_xml_element *element)
{
    struct pp_gbxml_model *model = r->model;
    const char *id = pp_gbxml_document_attribute(element, "id");
    int line = element->line;
    if (!id) {
        pp_mistakes_add(r->notes, line, "a Space without an id; left out");
        return PP_OK;
    }
    if (model->space_count == SPACES_MOST)
        return pp_fail(r->err, PP_BAD_INPUT,
                       "%s:%d: more than %d spaces, the most that are read", r->file,
                       line, SPACES_MOST);
    enum pp_status status = pp_array_append(&model->spaces, model->space_count,
                                            sizeof *model->spaces, r->err);
    if (status != PP_OK)
        return status;
    struct pp_gbxml_space *space = &model->spaces[model->space_count++];
    const char *name = pp_gbxml_document_text(pp_gbxml_document_child(element, "Name"));
    *space = (struct pp_gbxml_space){
        .line = line,
        .id = id,
        .name = name && *name ? name : NULL,
        .type = pp_gbxml_document_attribute(element, "spaceType")};
    const struct pp_xml_element *floor =
        pp_gbxml_document_path(element, "PlanarGeometry/PolyLoop");
    if (floor)
        read_loop(r, floor, &space->floor);
    return add_shell(r, space, element);
}

/* ---- the file ---- */

static void read_location(struct gbxml_reader *r, const struct pp_xml_element *campus)
{
    struct pp_gbxml_model *model = r->model;
    const struct pp_xml_element *location = pp_gbxml_document_child(campus, "Location");
    const struct pp_xml_element *azimuth =
        pp_gbxml_document_child(location, "CADModelAzimuth");
    double value;
    model->latitude = model->longitude = NAN;
    if (pp_gbxml_document_number(pp_gbxml_document_child(location, "Latitude"), &value)
        && fabs(value) <= 90.0)
        model->latitude = value;
    if (pp_gbxml_document_number(pp_gbxml_document_child(location, "Longitude"), &value)
        && fabs(value) <= 180.0)
        model->longitude = value;
    if (!azimuth || !pp_gbxml_document_number(azimuth, &value) || value == 0.0
        || !(fabs(value) <= 360.0))
        return;
    model->north_deg = value;
    pp_mistakes_add(
        r->notes, azimuth->line,
        "CADModelAzimuth %g is taken as the bearing of the plan's +y, "
        "clockwise from north, as the schema has it; some programs turn the "
        "other way",
        value);
}

static enum pp_status read_campus(struct gbxml_reader *r,
                                  const struct pp_xml_element *campus)
{
    enum pp_status status = PP_OK;
    for (const struct pp_xml_element *building =
             pp_gbxml_document_child(campus, "Building");
         building; building = pp_gbxml_document_next(building, "Building")) {
        if (!r->model->name)
            r->model->name =
                pp_gbxml_document_text(pp_gbxml_document_child(building, "Name"));
        for (const struct pp_xml_element *space =
                 pp_gbxml_document_child(building, "Space");
             space && status == PP_OK; space = pp_gbxml_document_next(space, "Space"))
            status = add_space(r, space);
    }
    for (const struct pp_xml_element *surface =
             pp_gbxml_document_child(campus, "Surface");
         surface && status == PP_OK;
         surface = pp_gbxml_document_next(surface, "Surface"))
        status = add_gbxml_surface(r, surface);
    return status;
}

enum pp_status pp_gbxml_read(struct pp_gbxml_model *model,
                             const struct pp_xml *document, const char *file,
                             struct pp_mistakes *notes, struct pp_error *err)
{
    struct gbxml_reader r = {.model = model,
                             .root = document->root,
                             .file = file,
                             .notes = notes,
                             .err = err};
    *model = (struct pp_gbxml_model){.latitude = NAN, .longitude = NAN};
    enum pp_status status = read_unit(&r);
    const struct pp_xml_element *campus = pp_gbxml_document_child(r.root, "Campus");
    if (status == PP_OK && !campus)
        status = pp_fail(err, PP_BAD_INPUT, "%s: it has no Campus", file);
    if (status == PP_OK)
        read_location(&r, campus);
    if (status == PP_OK)
        status = list_named(&r);
    if (status == PP_OK)
        status = read_campus(&r, campus);
    free(r.named);
    if (r.between > 0)
        pp_mistakes_add(notes, 0, "%d openings between spaces are taken as wall",
                        r.between);
    if (r.without_type > 0)
        pp_mistakes_add(
            notes, 0, "%d openings have no window type; clear-double is taken for them",
            r.without_type);
    if (status == PP_OK && model->space_count == 0)
        status = pp_fail(err, PP_BAD_INPUT, "%s: its Campus has no Space", file);
    return status;
}
