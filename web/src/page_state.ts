// Shared state of the page of a run: the time cursor, the time window of the plots, the pointer.

import { Clock, TimeWindow } from './clock';
import type { Phase, Run } from './data';

export class PageState {
  readonly clock: Clock;
  readonly window: TimeWindow;
  readonly phases: Phase[];
  readonly metricsWindow: [number, number] | null;
  hovered: number | null = null;
  private readonly hoverListeners: (() => void)[] = [];
  private readonly readingListeners: (() => void)[] = [];
  private lastReading = 0;
  private unread = true;

  constructor(readonly runs: Run[]) {
    const duration = Math.max(...runs.map((run) => run.time[run.time.length - 1] ?? run.duration));
    this.clock = new Clock(duration);
    this.window = new TimeWindow(duration);
    this.phases = runs[0]!.phases;
    this.metricsWindow = runs.length === 1 ? runs[0]!.window : null;
    this.clock.onTime((time) => {
      this.unread = true;
      if (this.clock.playing) this.window.follow(time);
    });
  }

  hover(time: number | null): void {
    this.hovered = time;
    this.unread = true;
    for (const listener of this.hoverListeners) listener();
  }
  onHover(listener: () => void): void {
    this.hoverListeners.push(listener);
  }

  /** Calls `listener` when displayed numbers must change, at most 15 times a second. */
  onReading(listener: () => void): void {
    this.readingListeners.push(listener);
  }
  frame(now: number): void {
    this.clock.tick(now);
    if (!this.unread || now - this.lastReading < 66) return;
    this.unread = false;
    this.lastReading = now;
    for (const listener of this.readingListeners) listener();
  }
}
