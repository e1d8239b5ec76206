/* main.c - the flight of examples/flight on FreeRTOS: a timer interrupt above the kernel takes the samples, messages
 * come by a queue.  `take` and what is printed at the end are those of examples/flight. */
#include <stdio.h>
#include <stdlib.h>
#include "FreeRTOS.h"
#include "board.h"
#include "queue.h"
#include "semphr.h"
#include "task.h"

#define AT(address) (*(volatile uint32_t *)(address))
enum { LINK = 0, SENSOR = 8 }; /* interrupts: of UART 0, pended by software, and of timer 0 */

__asm(".section .rodata\n.balign 8\nrecording: .incbin \"" RECORDING "\"\nrecording_end: .text");
extern const flight_head recording;
extern const flight_record recording_end[];

static const flight_record *volatile next = (const flight_record *)(&recording + 1);
static QueueHandle_t queue;
static SemaphoreHandle_t turn; /* to call what the header names the background */
static TaskHandle_t tasks[3];

void board_sample(const va_sample *sample) { (void)va_live_sample(&aboard, sample); }
void board_wait(void) {}

static void sensor_interrupt(void) /* above the kernel: it calls nothing of FreeRTOS */
{
    AT(0x4000000CU) = 1U; /* timer 0: it has been seen */
    for (; (next != recording_end) && (next->kind > 0.0); next += 1) {} /* messages, which the link has handed over */
    if (next != recording_end) {
        take(next++);
    }
    AT(0xE000E200U) = 1UL << LINK; /* pend it */
}

static void link_interrupt(void) /* below: messages that came behind the sample, and the background's call */
{
    BaseType_t woken = pdFALSE;
    for (const flight_record *one = next; (one != recording_end) && (one->kind > 0.0); ++one) {
        (void)xQueueSendFromISR(queue, &one, &woken);
    }
    vTaskNotifyGiveFromISR(tasks[0], &woken);
    portYIELD_FROM_ISR(woken);
}

static void background(void *unused)
{
    for ((void)unused;;) {
        bs_status status = BS_OK;
        (void)ulTaskNotifyTake(pdTRUE, portMAX_DELAY);
        while (status == BS_OK) { /* a message waits for one piece */
            (void)xSemaphoreTake(turn, portMAX_DELAY);
            status = va_live_background(&aboard);
            (void)xSemaphoreGive(turn);
        }
    }
}

static void output(void *unused) /* ten times per second, and the end */
{
    TickType_t woke = xTaskGetTickCount();
    unsigned int answers = 0U;
    for ((void)unused; next != recording_end;) {
        va_output out;
        (void)xTaskDelayUntil(&woke, pdMS_TO_TICKS(100));
        answers += (va_live_output(&aboard, (int64_t)next[-1].at, &out) == BS_OK) ? 1U : 0U;
    }
    (void)xSemaphoreTake(turn, portMAX_DELAY);
    while (va_live_background(&aboard) == BS_OK) {}
    report_end();
    (void)printf("%u outputs; words of stack left: background %lu, messages %lu\n", answers,
                 uxTaskGetStackHighWaterMark(tasks[0]), uxTaskGetStackHighWaterMark(tasks[2]));
    exit(0);
}

static void messages(void *unused)
{
    const flight_record *message;
    for ((void)unused;;) {
        (void)xQueueReceive(queue, &message, portMAX_DELAY);
        (void)xSemaphoreTake(turn, portMAX_DELAY);
        if (aboard.state != BS_LIVE_FLYING) { /* take will begin: no sample meanwhile */
            AT(0xE000E180U) = 1UL << SENSOR; /* taskENTER_CRITICAL does not stop it */
            __asm volatile("dsb\n\tisb" ::: "memory");
        }
        take(message);
        AT(0xE000E100U) = 1UL << SENSOR;
        (void)xSemaphoreGive(turn);
    }
}

int main(void)
{
    head = recording;
    queue = xQueueCreate(8U, sizeof(const flight_record *));
    turn = xSemaphoreCreateMutex();
    (void)xTaskCreate(background, "background", 600U, NULL, 1U, &tasks[0]); /* the lowest priority */
    (void)xTaskCreate(output, "output", 600U, NULL, 2U, &tasks[1]);
    (void)xTaskCreate(messages, "messages", 600U, NULL, 3U, &tasks[2]);
    AT(0xE000E400U + SENSOR) = 0x20U; /* priorities: above the kernel, and within its reach */
    AT(0xE000E400U + LINK) = 0x60U;
    AT(0x40000008U) = (configCPU_CLOCK_HZ / RATE) - 1U; /* timer 0: reload, and on */
    AT(0x40000000U) = 9U;
    AT(0xE000E100U) = (1UL << SENSOR) | (1UL << LINK);
    vTaskStartScheduler();
    return 1;
}

void reset(void), _start(void), vPortSVCHandler(void), xPortPendSVHandler(void), xPortSysTickHandler(void);
void reset(void)
{
    AT(0xE000ED88U) |= 0xFU << 20; /* CPACR: the FPU, before main uses it */
    __asm volatile("dsb\n\tisb");
    _start();
}
const uintptr_t vectors[25] __attribute__((section(".vectors"))) = {
    0x20400000U, (uintptr_t)&reset, [11] = (uintptr_t)&vPortSVCHandler, [14] = (uintptr_t)&xPortPendSVHandler,
    [15] = (uintptr_t)&xPortSysTickHandler, [16 + LINK] = (uintptr_t)&link_interrupt,
    [16 + SENSOR] = (uintptr_t)&sensor_interrupt,
};
