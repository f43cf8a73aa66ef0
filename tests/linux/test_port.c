/* The Linux port over a fake kernel: what arrives at the panel, and each thing that can go wrong, with its sentence and what is left afterwards. */
#include <errno.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fake_kernel.h"
#include "fixcast/fixcast.h"
#include "fixcast/panel.h"
#include "linux_bus.h"
#include "linux_probe.h"
#include "unity.h"

enum {
  SIDE = 240,
  STRIP = 16,
  FRAME_BYTES = SIDE * SIDE * 2
};

static const fc_linux_wiring wiring = {"/dev/spidev0.0", "GPIO25", "GPIO27", NULL};
static fc_linux_error error;
static fc_linux_bus *bus;
static fc_panel_state panel;
static fc_display display;
static uint8_t picture[FRAME_BYTES];

void setUp(void) {
  fake_board();
  virtual_open(&kernel.panel, &virtual_st7789_240);
  memset(&error, 0, sizeof error);
  bus = NULL;
  for (size_t i = 0; i < sizeof picture; i++) picture[i] = (uint8_t)((i * 2654435761u) >> 13);
}

static void assert_nothing_open(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, kernel.files, "files are open");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, kernel.handles, "chips, requests or other objects of libgpiod are left");
  for (unsigned i = 0; i < kernel.chip_count; i++)
    for (unsigned offset = 0; offset < kernel.chips[i].count; offset++) {
      const char *consumer = kernel.chips[i].lines[offset].consumer;
      TEST_ASSERT_TRUE_MESSAGE(consumer == NULL || strcmp(consumer, "fixcast") != 0, "a line is held");
    }
}

void tearDown(void) {
  kernel.thread_error = 0;
  fc_linux_bus_close(bus);
  assert_nothing_open();
}

/* ---- what works ---- */

static void open_bus(void) {
  bus = fc_linux_bus_open(&wiring, &error);
  TEST_ASSERT_NOT_NULL_MESSAGE(bus, error.text);
}

static int start(void) {
  const fc_bus interface = fc_linux_bus_ops(bus);
  return fc_panel_start(&panel, &fc_panel_st7789_240, &interface, NULL, &display);
}

/* Strips sent while the next is made, in two buffers, as fixcast show does. */
static int draw(void) {
  static uint8_t strips[2][SIDE * 2 * STRIP];
  int result = FC_OK, left;
  for (uint16_t y = 0; y < SIDE && result == FC_OK; y = (uint16_t)(y + STRIP)) {
    const fc_area area = {0, y, SIDE, STRIP};
    uint8_t *strip = strips[y / STRIP % 2];
    memcpy(strip, picture + y * SIDE * 2, sizeof strips[0]);
    result = fc_display_write_start(&display, &area, strip, SIDE * 2, NULL, NULL);
  }
  left = fc_display_wait(&display);
  return result != FC_OK ? result : left;
}

/* Five bits as eight, as the virtual panel shows them. */
static uint32_t colour_at(unsigned i) {
  const unsigned pixel = (unsigned)picture[2 * i] << 8 | picture[2 * i + 1];
  const uint32_t red = pixel >> 11, green = pixel >> 5 & 63, blue = pixel & 31;
  return (red << 3 | red >> 2) << 16 | (green << 2 | green >> 4) << 8 | (blue << 3 | blue >> 2);
}

static void assert_shown(void) {
  unsigned wrong = 0;
  for (unsigned i = 0; i < SIDE * SIDE; i++) wrong += virtual_shown(&kernel.panel, (uint16_t)(i % SIDE), (uint16_t)(i / SIDE)) != colour_at(i);
  TEST_ASSERT_EQUAL_UINT_MESSAGE(0, wrong, "wrong pixels");
}

static void assert_stream_whole(void) {
  virtual_finish(&kernel.panel);
  TEST_ASSERT_EQUAL_UINT_MESSAGE(0, kernel.panel.errors, kernel.panel.error);
}

static void test_a_frame_arrives_whole_and_the_panel_ends_asleep(void) {
  open_bus();
  TEST_ASSERT_EQUAL_INT(FC_OK, start());
  TEST_ASSERT_EQUAL_INT(FC_OK, draw());
  assert_shown();
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_panel_stop(&panel));
  assert_stream_whole();
  TEST_ASSERT_FALSE(kernel.panel.on);
  TEST_ASSERT_FALSE(kernel.panel.awake);
}

static void test_transfers_are_as_large_as_bufsiz_allows(void) {
  static const struct {
    const char *bufsiz;
    size_t limit, largest;
  } cases[] = {
      /* clang-format off */
      {"4096\n", 4096, 4096}, {"1000\n", 896, 896}, {"65536\n", 65536, SIDE * 2 * STRIP}, {NULL, 4096, 4096}, {"\n", 4096, 4096},
      {"100\n", 100, 100}};
  /* clang-format on */
  for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    setUp();
    kernel.bufsiz = cases[i].bufsiz;
    kernel.limit = cases[i].limit;
    open_bus();
    TEST_ASSERT_EQUAL_INT(FC_OK, start());
    TEST_ASSERT_EQUAL_INT(FC_OK, draw());
    assert_shown();
    TEST_ASSERT_EQUAL_size_t(cases[i].largest, kernel.largest_message);
    tearDown();
    bus = NULL;
  }
}

static void test_short_transfers_go_on_where_they_ended(void) {
  kernel.most = 77;
  open_bus();
  TEST_ASSERT_EQUAL_INT(FC_OK, start());
  TEST_ASSERT_EQUAL_INT(FC_OK, draw());
  assert_shown();
  assert_stream_whole();
}

static void count_ready(void *context, int result) {
  if (result == FC_OK) ++*(int *)context;
}

static void test_what_comes_after_a_transfer_waits_for_it(void) {
  const uint8_t window[2] = {0x2C, 0x29};
  int ready = 0;
  fc_bus interface;
  open_bus();
  TEST_ASSERT_EQUAL_INT(FC_OK, start());
  interface = fc_linux_bus_ops(bus);
  kernel.slow = true;
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->command(interface.context, &window[0], 1));
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->data_start(interface.context, picture, 9600, count_ready, &ready));
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->data_start(interface.context, picture + 9600, 9600, count_ready, &ready));
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->data(interface.context, picture + 19200, 9600));
  TEST_ASSERT_EQUAL_INT(2, ready);
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->data_start(interface.context, picture + 28800, FRAME_BYTES - 28800, count_ready, &ready));
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->command(interface.context, &window[1], 1));
  TEST_ASSERT_EQUAL_INT(3, ready);
  assert_shown();
  assert_stream_whole();
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->command(interface.context, &window[0], 1));
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->data_start(interface.context, picture, 9600, count_ready, &ready));
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->reset(interface.context, true));
  TEST_ASSERT_EQUAL_INT_MESSAGE(4, ready, "reset waits too");
}

static void test_a_transfer_is_under_way_while_the_caller_goes_on(void) {
  const uint8_t write = 0x2C;
  int ready = 0;
  fc_bus interface;
  open_bus();
  TEST_ASSERT_EQUAL_INT(FC_OK, start());
  interface = fc_linux_bus_ops(bus);
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->command(interface.context, &write, 1));
  kernel.gated = true;
  (void)pthread_mutex_lock(&fake_gate);
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->data_start(interface.context, picture, FRAME_BYTES, count_ready, &ready));
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, ready, "data_start returned although the transfer cannot have ended"); /* it waits for the gate */
  (void)pthread_mutex_unlock(&fake_gate);
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->wait(interface.context));
  TEST_ASSERT_EQUAL_INT(1, ready);
  assert_shown();
}

static void test_closing_waits_for_the_transfer_under_way(void) {
  const uint8_t write = 0x2C;
  int ready = 0;
  fc_bus interface;
  open_bus();
  TEST_ASSERT_EQUAL_INT(FC_OK, start());
  interface = fc_linux_bus_ops(bus);
  kernel.slow = true;
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->command(interface.context, &write, 1));
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->data_start(interface.context, picture, FRAME_BYTES, count_ready, &ready));
  fc_linux_bus_close(bus);
  bus = NULL;
  TEST_ASSERT_EQUAL_INT(1, ready);
  assert_shown();
}

static void test_mode_keeps_what_the_device_tree_says_and_the_clock_is_read_back(void) {
  fc_bus interface;
  open_bus();
  interface = fc_linux_bus_ops(bus);
  TEST_ASSERT_EQUAL_UINT32(0, interface.ops->clock_hz(interface.context));
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->configure(interface.context, 12000000, 3));
  TEST_ASSERT_EQUAL_HEX32(4, kernel.mode); /* SPI_CS_HIGH; mode 0 for either */
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->configure(interface.context, 11000000, 0));
  TEST_ASSERT_EQUAL_HEX32(4, kernel.mode);
  TEST_ASSERT_EQUAL_UINT32(11000000, interface.ops->clock_hz(interface.context));
}

static void test_only_the_lines_that_are_named_are_requested(void) {
  static const fc_linux_wiring all = {"/dev/spidev0.0", "soc-gpio:4", "GPIO27", "expander:3"};
  bus = fc_linux_bus_open(&all, &error);
  TEST_ASSERT_NOT_NULL_MESSAGE(bus, error.text);
  for (unsigned i = 0; i < FAKE_CHIPS; i++)
    for (unsigned offset = 0; offset < FAKE_LINES; offset++) {
      const bool named = i == 0 ? offset == 4 || offset == 5 : offset == 3;
      TEST_ASSERT_EQUAL_UINT(named, kernel.chips[i].lines[offset].requests);
    }
  TEST_ASSERT_TRUE_MESSAGE(kernel.reset->high, "reset is active low, and not active at first");
  TEST_ASSERT_FALSE_MESSAGE(kernel.chips[1].lines[3].high, "the light is off at first");
}

static void test_a_button_is_read_with_its_pull_up(void) {
  fc_linux_input *input = fc_linux_input_open("GPIO5", &error);
  TEST_ASSERT_NOT_NULL_MESSAGE(input, error.text);
  TEST_ASSERT_TRUE(kernel.chips[0].lines[3].pull_up);
  TEST_ASSERT_EQUAL_INT(0, fc_linux_input_read(input, &error));
  kernel.chips[0].lines[3].high = true;
  TEST_ASSERT_EQUAL_INT(1, fc_linux_input_read(input, &error));
  kernel.line_error = ENODEV;
  TEST_ASSERT_EQUAL_INT(FC_LINUX_ERROR(ENODEV), fc_linux_input_read(input, &error));
  TEST_ASSERT_EQUAL_STRING("button line 'GPIO5': get value: No such device; is the GPIO chip still there? 'fixcast probe' lists them", error.text);
  fc_linux_input_close(input);
}

/* ---- what cannot be opened ---- */

static void assert_refused(const fc_linux_wiring *wires, int code, const char *sentence) {
  printf("  %s\n", sentence);
  bus = fc_linux_bus_open(wires, &error);
  TEST_ASSERT_NULL_MESSAGE(bus, "opened, though it should not");
  TEST_ASSERT_EQUAL_STRING(sentence, error.text);
  TEST_ASSERT_EQUAL_INT(code, error.code);
  assert_nothing_open();
}

static void assert_line_refused(const char *dc, int code, const char *sentence) {
  const fc_linux_wiring wires = {"/dev/spidev0.0", dc, NULL, NULL};
  assert_refused(&wires, code, sentence);
}

static void test_no_permission_names_the_group_that_has_it(void) {
  kernel.spidev_error = EACCES;
  assert_refused(&wiring, FC_LINUX_ERROR(EACCES),
                 "/dev/spidev0.0: open: Permission denied; members of group 'spi' may open it: 'sudo usermod -aG spi NAME', then log in again");
  kernel.spidev_error = 0;
  kernel.chips[0].open_error = EACCES;
  assert_refused(&wiring, FC_LINUX_ERROR(EACCES),
                 "D/C line 'GPIO25': /dev/gpiochip0: open: Permission denied; members of group 'gpio' may open it: 'sudo usermod -aG gpio NAME', "
                 "then log in again");
  kernel.chips[0].open_error = 0;
  kernel.chips[1].open_error = EACCES; /* the line may be on that chip; its group has no name */
  assert_line_refused("GPIO99", FC_LINUX_ERROR(EACCES),
                      "D/C line 'GPIO99': /dev/gpiochip1: open: Permission denied; members of group '997' may open it: 'sudo usermod -aG 997 NAME', "
                      "then log in again");
}

static void test_no_such_device_names_those_that_exist(void) {
  const fc_linux_wiring wires = {"/dev/spidev1.0", "GPIO25", NULL, NULL};
  assert_refused(&wires, FC_LINUX_ERROR(ENOENT), "/dev/spidev1.0: open: No such file or directory; there are /dev/spidev0.0");
  kernel.spidev = false;
  assert_refused(&wires, FC_LINUX_ERROR(ENOENT),
                 "/dev/spidev1.0: open: No such file or directory; there is no /dev/spidev* at all: switch SPI on (Raspberry Pi: dtparam=spi=on in "
                 "config.txt)");
}

static void test_a_line_that_is_held_names_its_holder(void) {
  assert_line_refused("SPI_CE0", FC_LINUX_ERROR(EBUSY),
                      "D/C line 'SPI_CE0' (/dev/gpiochip0, offset 2): request: Device or resource busy; it is held by 'spi0 CS0': end that, or wire "
                      "another line");
  kernel.reset->consumer = "sysfs";
  assert_refused(&wiring, FC_LINUX_ERROR(EBUSY),
                 "reset line 'GPIO27' (/dev/gpiochip0, offset 5): request: Device or resource busy; it is held by 'sysfs': end that, or wire another "
                 "line");
}

static void test_no_such_line_names_those_that_are_free(void) {
  assert_line_refused("GPIO99", FC_LINUX_ERROR(0),
                      "D/C line 'GPIO99': no line has this name; free are SPI_SCLK, SPI_MOSI, GPIO5, GPIO25, GPIO27, GPIO18, GPIO4, expander:0 to "
                      "expander:3; 'fixcast probe' lists all");
  assert_line_refused("soc-gpio:8", FC_LINUX_ERROR(0), "D/C line 'soc-gpio:8': chip 'soc-gpio' has offsets 0 to 7 only");
  assert_line_refused("4", FC_LINUX_ERROR(0),
                      "D/C line '4': no line has this name; free are SPI_SCLK, SPI_MOSI, GPIO5, GPIO25, GPIO27, GPIO18, GPIO4, expander:0 to "
                      "expander:3; 'fixcast probe' lists all");
}

static void test_a_name_or_label_that_is_not_unique_is_refused(void) {
  kernel.chips[1].lines[0].name = "GPIO25";
  assert_refused(&wiring, FC_LINUX_ERROR(0),
                 "D/C line 'GPIO25': more than one line has this name, on chip 'soc-gpio' and on 'expander'; name it as CHIPLABEL:OFFSET");
  kernel.chips[1].label = "soc-gpio";
  assert_line_refused("soc-gpio:3", FC_LINUX_ERROR(0),
                      "D/C line 'soc-gpio:3': 2 chips have this label; use a line's name, 'fixcast probe' lists them");
}

static void test_a_line_is_found_by_name_before_label(void) {
  kernel.chips[1].lines[1].name = "soc-gpio:4";
  bus = fc_linux_bus_open(&(fc_linux_wiring){"/dev/spidev0.0", "soc-gpio:4", NULL, NULL}, &error);
  TEST_ASSERT_NOT_NULL_MESSAGE(bus, error.text);
  TEST_ASSERT_EQUAL_STRING("fixcast", kernel.chips[1].lines[1].consumer);
}

static void test_no_gpio_chip_at_all(void) {
  kernel.chip_count = 0;
  assert_refused(&wiring, FC_LINUX_ERROR(ENOENT), "D/C line 'GPIO25': there is no /dev/gpiochip*; this kernel has no GPIO driver for the board");
}

static void test_no_thread(void) {
  kernel.thread_error = EAGAIN;
  assert_refused(&wiring, FC_LINUX_ERROR(EAGAIN),
                 "cannot start a thread for transfers: Resource temporarily unavailable; end other programs or raise 'ulimit -u'");
}

static void test_no_wiring(void) {
  assert_refused(&(fc_linux_wiring){NULL, "GPIO25", NULL, NULL}, FC_LINUX_ERROR(EINVAL), "a display needs an SPI device and a D/C line");
}

/* ---- what goes wrong on the way ---- */

static void test_a_mode_or_clock_that_the_controller_has_not(void) {
  fc_bus interface;
  open_bus();
  interface = fc_linux_bus_ops(bus);
  TEST_ASSERT_EQUAL_INT(FC_ERR_UNSUPPORTED, interface.ops->configure(interface.context, 1000000, 1));
  kernel.hz_max = 5000000;
  TEST_ASSERT_EQUAL_INT(FC_LINUX_ERROR(EINVAL), interface.ops->configure(interface.context, 6000000, 0));
  TEST_ASSERT_EQUAL_STRING(
      "/dev/spidev0.0: SPI_IOC_WR_MAX_SPEED_HZ 6000000: Invalid argument; the controller cannot do this: try another --hz or "
      "another device",
      fc_linux_bus_error(bus)->text);
  TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->configure(interface.context, 5000000, 0));
}

/* A message that fails in mid-frame: its sentence, and afterwards the panel starts and draws again. */
static void fails_in_mid_frame(int number, const char *sentence) {
  printf("  %s\n", sentence);
  open_bus();
  TEST_ASSERT_EQUAL_INT(FC_OK, start());
  kernel.message_error = number;
  kernel.message_at = kernel.messages + 5 + 3; /* the window takes 5; then the second transfer of the second strip */
  TEST_ASSERT_EQUAL_INT(FC_LINUX_ERROR(number), draw());
  TEST_ASSERT_EQUAL_STRING(sentence, fc_linux_bus_error(bus)->text);
  TEST_ASSERT_EQUAL_INT(FC_LINUX_ERROR(number), fc_linux_bus_error(bus)->code);
  TEST_ASSERT_EQUAL_INT_MESSAGE(FC_OK, fc_display_wait(&display), "an error is told once");
  kernel.message_error = 0;
  TEST_ASSERT_EQUAL_INT(FC_OK, start());
  TEST_ASSERT_EQUAL_INT(FC_OK, draw());
  assert_shown();
  TEST_ASSERT_EQUAL_INT(FC_OK, fc_panel_stop(&panel));
}

static void test_an_io_error_in_mid_frame(void) {
  fails_in_mid_frame(EIO,
                     "/dev/spidev0.0: SPI_IOC_MESSAGE of 4096 bytes, after 0 of 7680: Input/output error; "
                     "try a slower clock (--hz) and look at the kernel's log (dmesg)");
}

static void test_a_device_that_vanishes_in_mid_frame(void) {
  fails_in_mid_frame(ESHUTDOWN,
                     "/dev/spidev0.0: SPI_IOC_MESSAGE of 4096 bytes, after 0 of 7680: Cannot send after transport endpoint shutdown; "
                     "the device has gone: is its driver still bound, the overlay still loaded?");
}

static void test_a_message_that_is_too_long_after_all(void) {
  open_bus();
  TEST_ASSERT_EQUAL_INT(FC_OK, start());
  kernel.limit = 4000;
  TEST_ASSERT_EQUAL_INT(FC_LINUX_ERROR(EMSGSIZE), draw());
  TEST_ASSERT_EQUAL_STRING(
      "/dev/spidev0.0: SPI_IOC_MESSAGE of 4096 bytes, after 0 of 7680: Message too long; spidev takes less at a time than its "
      "parameter bufsiz says: start again, or boot with spidev.bufsiz=65536",
      fc_linux_bus_error(bus)->text);
}

static void test_a_gpio_chip_that_vanishes(void) {
  open_bus();
  TEST_ASSERT_EQUAL_INT(FC_OK, start());
  kernel.line_error = ENODEV;
  TEST_ASSERT_EQUAL_INT(FC_LINUX_ERROR(ENODEV), draw());
  TEST_ASSERT_EQUAL_STRING("D/C line 'GPIO25': set value: No such device; is the GPIO chip still there? 'fixcast probe' lists them",
                           fc_linux_bus_error(bus)->text);
  kernel.line_error = 0;
  TEST_ASSERT_EQUAL_INT(FC_OK, start());
  TEST_ASSERT_EQUAL_INT(FC_OK, draw());
  assert_shown();
}

/* Each call that can fail does so once: nothing is left open, and the next time it works. */
static void test_any_call_of_opening_may_fail_and_leaves_nothing(void) {
  unsigned refused = 0, at;
  for (at = 1; at < 1000; at++) {
    kernel.calls = 0;
    kernel.fail_at = at;
    bus = fc_linux_bus_open(&(fc_linux_wiring){"/dev/spidev0.0", "GPIO25", "GPIO27", "expander:1"}, &error);
    if (bus == NULL) {
      refused++;
      TEST_ASSERT_TRUE(error.text[0] != '\0' && error.code <= FC_LINUX_ERROR(0));
    }
    fc_linux_bus_close(bus);
    bus = NULL;
    assert_nothing_open();
    if (kernel.calls < at) break; /* there are no more calls */
  }
  kernel.fail_at = 0;
  TEST_ASSERT_TRUE_MESSAGE(at > 20 && at < 1000 && refused >= 8, "opening makes more than 20 calls, of which some are essential");
}

static void test_any_call_of_a_frame_may_fail_and_the_panel_starts_again(void) {
  unsigned failed = 0, at;
  for (at = 1; at < 1000; at++) {
    int result;
    open_bus();
    kernel.calls = 0;
    kernel.fail_at = at;
    result = start();
    if (result == FC_OK) result = draw();
    if (result != FC_OK) {
      failed++;
      TEST_ASSERT_EQUAL_INT(FC_LINUX_ERROR(EIO), result);
      TEST_ASSERT_EQUAL_INT(FC_LINUX_ERROR(EIO), fc_linux_bus_error(bus)->code);
    }
    kernel.fail_at = 0;
    if (at % 16 == 1) {
      TEST_ASSERT_EQUAL_INT(FC_OK, start());
      TEST_ASSERT_EQUAL_INT(FC_OK, draw());
      assert_shown();
    }
    fc_linux_bus_close(bus);
    bus = NULL;
    assert_nothing_open();
    if (result == FC_OK) break;
  }
  TEST_ASSERT_TRUE_MESSAGE(at > 50 && failed == at - 1, "each of more than 50 calls failed once, and was told");
}

static void test_a_thousand_open_and_close_cycles_leave_nothing(void) {
  const uint8_t command = 0;
  for (int i = 0; i < 1000; i++) {
    fc_bus interface;
    open_bus();
    interface = fc_linux_bus_ops(bus);
    TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->configure(interface.context, 1000000, 0));
    TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->command(interface.context, &command, 1));
    TEST_ASSERT_EQUAL_INT(FC_OK, interface.ops->data_start(interface.context, picture, 1, NULL, NULL));
    fc_linux_bus_close(bus);
    bus = NULL;
    assert_nothing_open();
  }
}

static void count_spi(void *context, const fc_linux_node *node) {
  (void)node;
  ++*(int *)context;
}

static void count_chip(void *context, const fc_linux_node *node, const char *label, unsigned lines) {
  const bool first = strcmp(node->path, "/dev/gpiochip0") == 0 && lines == FAKE_LINES && strcmp(node->group, "gpio") == 0;
  *(int *)context += 10 * (label != NULL) + 100 * first;
}

static void count_line(void *context, unsigned offset, const char *name, const char *consumer, bool used, bool output) {
  (void)output;
  *(int *)context += 1000 + 100000 * (offset == 2 && strcmp(name, "SPI_CE0") == 0 && used && strcmp(consumer, "spi0 CS0") == 0);
}

static void test_probe_tells_devices_chips_and_lines_and_requests_none(void) {
  static const fc_linux_probe_calls calls = {count_spi, count_chip, count_line};
  int count = 0;
  fc_linux_probe(&calls, &count);
  TEST_ASSERT_EQUAL_INT(1 + 2 * 10 + 100 + 12 * 1000 + 100000, count);
  count = 0;
  kernel.chips[1].open_error = EACCES; /* is told, without lines */
  fc_linux_probe(&calls, &count);
  TEST_ASSERT_EQUAL_INT(1 + 10 + 100 + 8 * 1000 + 100000, count);
  TEST_ASSERT_EQUAL_UINT(0, kernel.chips[0].lines[3].requests);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_no_permission_names_the_group_that_has_it);
  RUN_TEST(test_no_such_device_names_those_that_exist);
  RUN_TEST(test_a_line_that_is_held_names_its_holder);
  RUN_TEST(test_no_such_line_names_those_that_are_free);
  RUN_TEST(test_a_name_or_label_that_is_not_unique_is_refused);
  RUN_TEST(test_a_line_is_found_by_name_before_label);
  RUN_TEST(test_no_gpio_chip_at_all);
  RUN_TEST(test_no_thread);
  RUN_TEST(test_no_wiring);
  RUN_TEST(test_a_mode_or_clock_that_the_controller_has_not);
  RUN_TEST(test_an_io_error_in_mid_frame);
  RUN_TEST(test_a_device_that_vanishes_in_mid_frame);
  RUN_TEST(test_a_message_that_is_too_long_after_all);
  RUN_TEST(test_a_gpio_chip_that_vanishes);
  RUN_TEST(test_any_call_of_opening_may_fail_and_leaves_nothing);
  RUN_TEST(test_any_call_of_a_frame_may_fail_and_the_panel_starts_again);
  RUN_TEST(test_a_frame_arrives_whole_and_the_panel_ends_asleep);
  RUN_TEST(test_transfers_are_as_large_as_bufsiz_allows);
  RUN_TEST(test_short_transfers_go_on_where_they_ended);
  RUN_TEST(test_what_comes_after_a_transfer_waits_for_it);
  RUN_TEST(test_a_transfer_is_under_way_while_the_caller_goes_on);
  RUN_TEST(test_closing_waits_for_the_transfer_under_way);
  RUN_TEST(test_mode_keeps_what_the_device_tree_says_and_the_clock_is_read_back);
  RUN_TEST(test_only_the_lines_that_are_named_are_requested);
  RUN_TEST(test_a_button_is_read_with_its_pull_up);
  RUN_TEST(test_a_thousand_open_and_close_cycles_leave_nothing);
  RUN_TEST(test_probe_tells_devices_chips_and_lines_and_requests_none);
  return UNITY_END();
}
