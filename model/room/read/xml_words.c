/* xml_words.c - see xml_words.h. */
#include "model/room/read/xml_words.h"

#include <stdio.h>
#include <string.h>

#include "model/base/text.h"

/* Errors that have one sentence each, whatever the file. */
static const struct {
    int code;
    const char *sentence;
} sentences[] = {
    {XML_ERR_LT_IN_ATTRIBUTE,
     "a < in an attribute's value; write &lt;, or is a quotation mark missing?"},
    {XML_ERR_ATTRIBUTE_NOT_STARTED,
     "an attribute's value is not in quotation marks; write name=\"value\""},
    {XML_ERR_ATTRIBUTE_NOT_FINISHED,
     "an attribute's value has no closing quotation mark"},
    {XML_ERR_ATTRIBUTE_WITHOUT_VALUE,
     "an attribute has no value; write name=\"value\""},
    {XML_ERR_SPACE_REQUIRED,
     "a tag is malformed here; expected a space, > or />, or is a "
     "quotation mark missing?"},
    {XML_ERR_GT_REQUIRED, "a tag is not closed; expected > or />"},
    {XML_ERR_NAME_REQUIRED,
     "a name was expected after < or &; write &lt; or &amp; for the sign itself"},
    {XML_ERR_ENTITYREF_SEMICOL_MISSING,
     "an & without its name and semicolon; write &amp; for the sign itself"},
    {XML_ERR_ENTITYREF_NO_NAME,
     "an & without its name and semicolon; write &amp; for the sign itself"},
    {XML_ERR_INVALID_CHARREF,
     "a character reference like &#...; that XML does not allow"},
    {XML_ERR_INVALID_HEX_CHARREF,
     "a character reference like &#x...; that XML does not allow"},
    {XML_ERR_INVALID_DEC_CHARREF,
     "a character reference like &#...; that XML does not allow"},
    {XML_ERR_INVALID_CHAR, "a control character that XML does not allow"},
    {XML_ERR_COMMENT_NOT_FINISHED, "a comment <!-- has no end; expected -->"},
    {XML_ERR_HYPHEN_IN_COMMENT, "two hyphens -- within a comment"},
    {XML_ERR_PI_NOT_FINISHED, "a <? has no end; expected ?>"},
    {XML_ERR_CDATA_NOT_FINISHED, "a <![CDATA[ has no end; expected ]]>"},
    {XML_ERR_MISPLACED_CDATA_END, "]]> stands between elements"},
    {XML_ERR_RESERVED_XML_NAME, "<?xml ...?> must be the very first thing in the file"},
    {XML_ERR_XMLDECL_NOT_STARTED, "the <?xml ...?> at the start is malformed"},
    {XML_ERR_XMLDECL_NOT_FINISHED, "the <?xml ...?> at the start is not closed by ?>"},
    {XML_ERR_VERSION_MISSING,
     "the <?xml ...?> at the start has no version; write version=\"1.0\""},
    {XML_ERR_DOCUMENT_EMPTY, "this is not XML; expected a <room> or a <building>"},
    {XML_ERR_DOCUMENT_START, "this is not XML; expected a <room> or a <building>"},
    {XML_ERR_DOCUMENT_END,
     "something stands behind the end of the room; a file holds one room or building"},
};

/* Errors that the end of the file in the middle of a tag may cause. */
static bool breaks_off(int code)
{
    switch (code) {
    case XML_ERR_TAG_NOT_FINISHED:
    case XML_ERR_SPACE_REQUIRED:
    case XML_ERR_GT_REQUIRED:
    case XML_ERR_NAME_REQUIRED:
    case XML_ERR_ATTRIBUTE_NOT_STARTED:
    case XML_ERR_ATTRIBUTE_NOT_FINISHED:
    case XML_ERR_ATTRIBUTE_WITHOUT_VALUE:
    case XML_ERR_LT_IN_ATTRIBUTE:
    case XML_ERR_ENTITYREF_SEMICOL_MISSING:
    case XML_ERR_INVALID_CHARREF:
    case XML_ERR_INVALID_DEC_CHARREF:
    case XML_ERR_INVALID_HEX_CHARREF:
        return true;
    default:
        return false;
    }
}

/* Does nothing but white space follow, or the / of an unclosed tag? */
static bool at_the_end(const struct pp_xml_place *place)
{
    const char *p = place->bytes + place->position;
    const char *end = place->bytes + place->length;
    if (p < end && *p == '/')
        p++;
    while (p < end && (*p == ' ' || *p == '\t' || *p == '\r' || *p == '\n'))
        p++;
    return p == end;
}

/* Where the last of `what` begins before the place, or the place if there is none. */
static size_t find_back(const struct pp_xml_place *place, const char *what)
{
    size_t length = strlen(what);
    for (size_t p = place->position; p-- > 0;)
        if (place->length - p >= length && memcmp(place->bytes + p, what, length) == 0)
            return p;
    return place->position;
}

/* An attribute's name was expected, but the next tag begins. */
static bool is_unclosed_tag(int code, const struct pp_xml_place *place)
{
    return code == XML_ERR_NAME_REQUIRED && place->position < place->length
           && place->bytes[place->position] == '<';
}

static size_t cause_of(int code, const struct pp_xml_place *place)
{
    size_t here = place->position, twice, once;
    switch (code) {
    case XML_ERR_LT_IN_ATTRIBUTE: /* a value without its end runs on to the next tag */
    case XML_ERR_ATTRIBUTE_NOT_FINISHED:
        twice = find_back(place, "\"");
        once = find_back(place, "'");
        return once == here || (twice != here && twice > once) ? twice : once;
    case XML_ERR_COMMENT_NOT_FINISHED:
        return find_back(place, "<!--");
    case XML_ERR_PI_NOT_FINISHED:
        return find_back(place, "<?");
    case XML_ERR_CDATA_NOT_FINISHED:
        return find_back(place, "<![CDATA[");
    default:
        return is_unclosed_tag(code, place) ? find_back(place, "<") : here;
    }
}

static void write_sentence(char *text, size_t size, const xmlError *error,
                           const struct pp_xml_place *place)
{
    const struct pp_xml_element *open = place->open;
    char one[160], other[160];
    if (at_the_end(place) && breaks_off(error->code)) {
        if (open)
            snprintf(text, size,
                     "the file breaks off within <%s> of line %d; expected </%s>",
                     pp_text_excerpt(one, sizeof one, open->name), open->line,
                     pp_text_excerpt(other, sizeof other, open->name));
        else
            snprintf(text, size, "the file breaks off within a tag");
        return;
    }
    if (is_unclosed_tag(error->code, place)) {
        snprintf(text, size, "this tag is not closed; expected > or /> at its end");
        return;
    }
    switch (error->code) {
    case XML_ERR_TAG_NAME_MISMATCH:
        snprintf(text, size, "</%s> where </%s> was expected, to close line %d",
                 pp_text_excerpt(other, sizeof other, error->str2 ? error->str2 : ""),
                 pp_text_excerpt(one, sizeof one, open ? open->name : ""),
                 open ? open->line : 1);
        return;
    case XML_ERR_ATTRIBUTE_REDEFINED:
        snprintf(text, size, "the attribute \"%s\" is given twice",
                 pp_text_excerpt(one, sizeof one, error->str1 ? error->str1 : ""));
        return;
    case XML_ERR_UNDECLARED_ENTITY:
    case XML_WAR_UNDECLARED_ENTITY:
        snprintf(text, size,
                 "&%s; is not known; XML has &amp; &lt; &gt; &quot; and &apos;",
                 pp_text_excerpt(one, sizeof one, error->str1 ? error->str1 : ""));
        return;
    default:
        break;
    }
    for (size_t i = 0; i < sizeof sentences / sizeof *sentences; i++)
        if (error->code == sentences[i].code) {
            snprintf(text, size, "%s", sentences[i].sentence);
            return;
        }
    char copy[128] = "";
    snprintf(copy, sizeof copy, "%s", error->message ? error->message : "");
    copy[strcspn(copy, "\n")] = '\0';
    snprintf(text, size, "not well-formed XML: %s", copy);
}

size_t pp_xml_words_sentence(char *text, size_t size, const xmlError *error,
                             const struct pp_xml_place *place)
{
    write_sentence(text, size, error, place);
    return cause_of(error->code, place);
}
