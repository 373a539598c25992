/* atlas_outside.c - skylines, blocks, slabs and facades as elements of a room file. */
#include "studies/research/atlas/atlas_outside.h"

#include <math.h>

static void block(struct pp_atlas_layout *room, double x, double y, double width,
                  double depth, double height, double reflectance)
{
    PP_SAY(room,
           "  <block x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" depth=\"%.2f\" base=\"%.2f\" "
           "height=\"%.2f\" reflectance=\"%.2f\"/>\n",
           x, y, width, depth, room->ground, height, reflectance);
}

static void facade(struct pp_atlas_layout *room, double aside, double up,
                   double reflectance)
{
    PP_SAY(room,
           "  <facade wall=\"south\" left=\"%.2f\" right=\"%.2f\" up=\"%.2f\" "
           "down=\"%.2f\" reflectance=\"%.2f\"/>\n",
           aside, aside, up, -room->ground, reflectance);
}

/* Writes a slab above the windows of the south wall. */
static void put_balcony(struct pp_atlas_layout *room, const double u[6])
{
    double out = pp_between(0.5, 2.2, u[1]),
           z = fmax(room->head + 0.05, room->lowest[PP_ATLAS_SOUTH]);
    double low = pp_between(-1.0, 0.0, u[2]), high = room->width - low;
    PP_SAY(room,
           "  <surface reflectance=\"%.2f\"><vertex x=\"%.2f\" y=\"%.2f\" z=\"%.2f\"/>"
           "<vertex x=\"%.2f\" y=\"%.2f\" z=\"%.2f\"/><vertex x=\"%.2f\" y=\"-0.45\" "
           "z=\"%.2f\"/><vertex x=\"%.2f\" y=\"-0.45\" z=\"%.2f\"/></surface>\n",
           pp_between(0.2, 0.6, u[3]), low, -0.45 - out, z, high, -0.45 - out, z, high,
           z, low, z);
}

/* Writes a court: the block opposite, two blocks that close the sides, and the facade
 * around the windows. */
static void put_court(struct pp_atlas_layout *room, double distance, double half,
                      double height, double reflectance)
{
    double middle = 0.5 * room->width, thick = 6.0;
    block(room, middle - half - thick, -distance - thick, 2.0 * (half + thick), thick,
          height, reflectance);
    block(room, middle - half - thick, -distance, thick, distance - 0.5, height,
          reflectance);
    block(room, middle + half, -distance, thick, distance - 0.5, height, reflectance);
    facade(room, half, fmax(height + room->ground - room->eaves, 0.0), reflectance);
}

static void put_street(struct pp_atlas_layout *room, const double u[6])
{
    double distance = pp_scaled_ends(room->ranges->street_m, u[1]),
           height = distance * pp_between_ends(room->ranges->street, u[2]);
    double length = room->width * pp_scaled(1.0, 12.0, u[3]),
           middle = 0.5 * room->width;
    double reflectance = pp_between(0.1, 0.5, u[4]);
    block(room, middle - 0.5 * length, -distance - 10.0, length, 10.0,
          height - room->ground, reflectance);
    if (u[5] < 0.5)
        facade(room, 0.5 * length, fmax(height - room->eaves, 0.0), reflectance);
}

void pp_atlas_outside_put(struct pp_atlas_layout *room, bool windows)
{
    const struct pp_atlas_ranges *ranges = room->ranges;
    double u[6], reflectance;
    pp_atlas_draw(room, PP_ATLAS_OUTSIDE, u);
    enum pp_atlas_surroundings kind =
        (enum pp_atlas_surroundings)PP_ONE_OF(ranges->surroundings, &u[0]);
    reflectance = pp_between(0.1, 0.6, u[4]);
    if (!windows || room->roof != PP_ATLAS_FLAT)
        kind = kind == PP_ATLAS_STREET || kind == PP_ATLAS_ASIDE
                       || (windows && kind == PP_ATLAS_FAR_SKYLINE)
                   ? kind
                   : PP_ATLAS_NOTHING;
    switch (kind) {
    case PP_ATLAS_NOTHING:
    case PP_ATLAS_SURROUNDINGS:
        break;
    case PP_ATLAS_FAR_SKYLINE:
        PP_SAY(room,
               "  <skyline wall=\"south\" angle=\"%.1f\" reflectance=\"%.2f\"/>\n",
               pp_between_ends(ranges->far_deg, u[1]), reflectance);
        break;
    case PP_ATLAS_NEAR_SKYLINE:
        PP_SAY(room,
               "  <skyline wall=\"south\" angle=\"%.1f\" distance=\"%.1f\" "
               "reflectance=\"%.2f\"/>\n",
               pp_between_ends(ranges->near_deg, u[1]),
               pp_scaled_ends(ranges->near_m, u[2]), reflectance);
        break;
    case PP_ATLAS_STREET:
        put_street(room, u);
        break;
    case PP_ATLAS_LIGHT_WELL:
        put_court(room, pp_between(2.0, 6.0, u[1]),
                  0.5 * room->width + pp_between(0.0, 2.0, u[2]),
                  pp_between(4.0, 15.0, u[3]) - room->ground,
                  pp_between(0.2, 0.7, u[4]));
        break;
    case PP_ATLAS_COURT:
        put_court(room, pp_scaled(6.0, 25.0, u[1]),
                  0.5 * room->width + pp_between(1.0, 10.0, u[2]),
                  pp_between(3.0, 15.0, u[3]) - room->ground, reflectance);
        break;
    case PP_ATLAS_BALCONY:
        put_balcony(room, u);
        break;
    case PP_ATLAS_FACADE:
        facade(room, pp_between(1.0, 15.0, u[1]), pp_between(0.0, 12.0, u[2]),
               reflectance);
        break;
    case PP_ATLAS_ASIDE: {
        double distance = pp_scaled(2.0, 15.0, u[1]),
               height = pp_between(3.0, 20.0, u[2]);
        block(room, pp_between(0.0, 1.5, u[3]) * room->width, -distance - 8.0, 12.0,
              8.0, height - room->ground, reflectance);
        break;
    }
    }
}

void pp_atlas_outside_site(struct pp_atlas_layout *room)
{
    double u[6], ground = 1.0 - room->ranges->snow;
    pp_atlas_draw(room, PP_ATLAS_PLACE, u);
    room->ground = u[0] < 0.6 ? 0.0 : -3.0 * floor(1.0 + 4.999 * (u[0] - 0.6) / 0.4);
    PP_SAY(room, "  <site ground-reflectance=\"%.2f\" ground-level=\"%.1f\"/>\n",
           u[1] < ground ? pp_between_ends(room->ranges->ground, u[1] / ground)
                         : pp_between(0.6, 0.85, (u[1] - ground) / room->ranges->snow),
           room->ground);
    if (room->design->sky == PP_ATLAS_OVERCAST)
        return;
    pp_atlas_draw(room, PP_ATLAS_SKY, u);
    PP_SAY(room,
           "  <sky type=\"iso-%d\" sun-altitude=\"%.1f\" sun-bearing=\"%.1f\"/>\n",
           1 + (int)(15.0 * u[0]), pp_between(5.0, 80.0, u[1]),
           pp_between(0.0, 360.0, u[2]));
}
