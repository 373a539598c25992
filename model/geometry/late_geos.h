/* late_geos.h - what is called of GEOS, which is loaded where outlines are cut or joined: with
 * the library of C++ it would be half of the time that a program takes to start, and rooms
 * that are boxes do without. The one file that includes GEOS; inside model/geometry/ only.
 */
#ifndef PP_MODEL_GEOMETRY_LATE_GEOS_H
#define PP_MODEL_GEOMETRY_LATE_GEOS_H

#include <geos_c.h>

#include "model/base/error.h"

/* clang-format off */
#define PP_LATE_GEOS_FUNCTIONS(each) \
    each(GEOSBufferWithStyle_r) each(GEOSConstrainedDelaunayTriangulation_r) \
    each(GEOSContext_setErrorMessageHandler_r) each(GEOSCoordSeq_create_r) \
    each(GEOSCoordSeq_getSize_r) each(GEOSCoordSeq_getXY_r) \
    each(GEOSCoordSeq_setXY_r) each(GEOSDifferencePrec_r) each(GEOSDifference_r) \
    each(GEOSGeomGetX_r) each(GEOSGeomGetY_r) each(GEOSGeomTypeId_r) \
    each(GEOSGeom_clone_r) each(GEOSGeom_createCollection_r) \
    each(GEOSGeom_createLinearRing_r) each(GEOSGeom_createPolygon_r) \
    each(GEOSGeom_destroy_r) each(GEOSGeom_getCoordSeq_r) \
    each(GEOSGetExteriorRing_r) each(GEOSGetGeometryN_r) \
    each(GEOSGetInteriorRingN_r) each(GEOSGetNumGeometries_r) \
    each(GEOSGetNumInteriorRings_r) each(GEOSIntersectionPrec_r) \
    each(GEOSIntersection_r) each(GEOSPointOnSurface_r) each(GEOSPolygonize_r) \
    each(GEOSUnaryUnionPrec_r) each(GEOSUnaryUnion_r) each(GEOS_finish_r) \
    each(GEOS_init_r) each(GEOSisEmpty_r) each(GEOSisValid_r)
/* clang-format on */

/* GEOS's functions by their own names: geos->call.GEOSisValid_r(geos->context, ...). */
struct pp_late_geos {
    GEOSContextHandle_t context;
    struct pp_late_geos_functions {
#define PP_LATE_GEOS_MEMBER(name) __typeof__(name) *name;
        PP_LATE_GEOS_FUNCTIONS(PP_LATE_GEOS_MEMBER)
#undef PP_LATE_GEOS_MEMBER
    } call;
};

/* Loads GEOS and makes a context; what GEOS says of a failure goes to `say`. */
enum pp_status pp_late_geos_load(struct pp_late_geos *geos, GEOSMessageHandler_r say,
                                 void *say_to, struct pp_error *err);
/* Ends the context, if there is one. */
void pp_late_geos_finish(struct pp_late_geos *geos);

#endif
