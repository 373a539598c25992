/* test_http_guard.c - requests that are accepted: names of the server, origins,
 * tokens. */
#include "tests/lib/near.h"

#include "serve/http/http_guard.h"

static const struct pp_serve_options own = {.address = NULL};
static const struct pp_serve_options open_to_all = {.address = "0.0.0.0",
                                                    .token = "a-token-of-length",
                                                    .hosts = {"light.example"},
                                                    .host_count = 1};

static void a_loopback_server_goes_by_its_own_names_only(void **state)
{
    (void)state;
    assert_true(pp_http_guard_host(&own, "127.0.0.1:8000"));
    assert_true(pp_http_guard_host(&own, "localhost:8000"));
    assert_true(pp_http_guard_host(&own, "LOCALHOST"));
    assert_true(pp_http_guard_host(&own, "[::1]:8000"));
    assert_false(pp_http_guard_host(&own, "evil.example:8000"));
    assert_false(pp_http_guard_host(&own, "192.168.1.2:8000"));
    assert_false(pp_http_guard_host(&own, "127.0.0.1.evil.example"));
    assert_false(pp_http_guard_host(&own, "localhost.evil.example"));
    assert_false(pp_http_guard_host(&own, ""));
    assert_false(pp_http_guard_host(&own, "[::1"));
    assert_false(pp_http_guard_host(&own, NULL));
}

/* Anybody can make a name point to the server, but not a number. */
static void an_open_server_goes_by_numbers_and_the_names_it_was_given(void **state)
{
    (void)state;
    assert_true(pp_http_guard_host(&open_to_all, "192.168.1.2:8000"));
    assert_true(pp_http_guard_host(&open_to_all, "light.example"));
    assert_false(pp_http_guard_host(&open_to_all, "evil.example"));
}

static void tokens_agree_as_a_whole(void **state)
{
    (void)state;
    assert_true(pp_http_guard_same(NULL, NULL));
    assert_true(pp_http_guard_same("secret", "secret"));
    assert_false(pp_http_guard_same("secret", "secre"));
    assert_false(pp_http_guard_same("secret", "secrets"));
    assert_false(pp_http_guard_same("secret", "Secret"));
    assert_false(pp_http_guard_same("secret", ""));
    assert_false(pp_http_guard_same("secret", NULL));
}

static unsigned checked(const struct pp_serve_options *options,
                        struct pp_http_headers headers)
{
    const char *why;
    headers.method = "POST";
    if (!headers.content_type)
        headers.content_type = "application/json; charset=utf-8";
    return pp_http_guard_check(options, &headers, "application/json", false,
                               options->token, &why);
}

static void requests_of_other_pages_are_refused(void **state)
{
    (void)state;
    assert_int_equal(checked(&own, (struct pp_http_headers){.host = "localhost:1"}), 0);
    assert_int_equal(
        checked(&own, (struct pp_http_headers){.host = "localhost:1",
                                               .origin = "http://localhost:1"}),
        0);
    assert_int_equal(
        checked(&own, (struct pp_http_headers){.host = "localhost:1",
                                               .origin = "http://localhost:2"}),
        403);
    assert_int_equal(checked(&own, (struct pp_http_headers){.host = "localhost:1",
                                                            .origin = "null"}),
                     403);
    assert_int_equal(
        checked(&own, (struct pp_http_headers){.host = "localhost:1",
                                               .fetch_site = "cross-site"}),
        403);
    assert_int_equal(checked(&own, (struct pp_http_headers){.host = "evil.example"}),
                     421);
}

/* Types other than JSON; a form on any web page can post the first three without a
 * preflight request. */
static void types_that_a_form_can_post_are_refused(void **state)
{
    (void)state;
    static const char *const types[] = {"application/x-www-form-urlencoded",
                                        "multipart/form-data; boundary=x", "text/plain",
                                        "application/jsonx", ""};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        assert_int_equal(
            checked(&own, (struct pp_http_headers){.host = "localhost",
                                                   .content_type = types[i]}),
            415);
}

static void an_open_server_asks_for_its_token(void **state)
{
    (void)state;
    struct pp_http_headers headers = {.host = "10.0.0.1"};
    assert_int_equal(checked(&open_to_all, headers), 401);
    headers.authorization = "Bearer a-token-of-lengtH";
    assert_int_equal(checked(&open_to_all, headers), 401);
    headers.authorization = "Basic a-token-of-length";
    assert_int_equal(checked(&open_to_all, headers), 401);
    headers.authorization = "Bearer a-token-of-length";
    assert_int_equal(checked(&open_to_all, headers), 0);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_loopback_server_goes_by_its_own_names_only),
        cmocka_unit_test(an_open_server_goes_by_numbers_and_the_names_it_was_given),
        cmocka_unit_test(tokens_agree_as_a_whole),
        cmocka_unit_test(requests_of_other_pages_are_refused),
        cmocka_unit_test(types_that_a_form_can_post_are_refused),
        cmocka_unit_test(an_open_server_asks_for_its_token),
    };
    add_tests(tests, NULL, NULL);
}
