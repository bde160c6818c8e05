// Time cursor of the page, and the time window of the plots.

export const speeds = [0.1, 0.25, 0.5, 1, 2, 4];

export class Clock {
  time = 0;
  playing = false;
  speed = 1;
  private last = 0;
  private readonly listeners: ((time: number) => void)[] = [];
  private readonly stateListeners: (() => void)[] = [];

  constructor(readonly duration: number) {}

  onTime(listener: (time: number) => void): void {
    this.listeners.push(listener);
  }
  onState(listener: () => void): void {
    this.stateListeners.push(listener);
  }

  set(time: number): void {
    const next = Math.min(Math.max(time, 0), this.duration);
    if (next === this.time) return;
    this.time = next;
    for (const listener of this.listeners) listener(next);
  }

  setSpeed(speed: number): void {
    this.speed = speed;
    this.changed();
  }

  play(): void {
    if (this.playing) return;
    if (this.time >= this.duration) this.set(0);
    this.playing = true;
    this.last = performance.now();
    this.changed();
  }

  pause(): void {
    if (!this.playing) return;
    this.playing = false;
    this.changed();
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  /** Advances the time while playing, by at most 0.5 s of real time per frame. */
  tick(now: number): void {
    if (!this.playing) return;
    const passed = Math.min(Math.max((now - this.last) / 1000, 0), 0.5);
    this.last = now;
    this.set(this.time + passed * this.speed);
    if (this.time >= this.duration) this.pause();
  }

  private changed(): void {
    for (const listener of this.stateListeners) listener();
  }
}

/** Time window that all plots show. */
export class TimeWindow {
  min = 0;
  max: number;
  private readonly listeners: (() => void)[] = [];

  constructor(readonly duration: number) {
    this.max = duration;
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  get whole(): boolean {
    return this.min <= 0 && this.max >= this.duration;
  }

  set(min: number, max: number): void {
    const width = Math.min(Math.max(max - min, 5e-3), this.duration);
    const start = Math.min(Math.max(min, 0), this.duration - width);
    if (start === this.min && start + width === this.max) return;
    this.min = start;
    this.max = start + width;
    for (const listener of this.listeners) listener();
  }

  reset(): void {
    this.set(0, this.duration);
  }

  /** Scales the window about a time; a factor below 1 narrows it. */
  zoom(factor: number, about: number): void {
    const centre = Math.min(Math.max(about, this.min), this.max);
    this.set(centre - (centre - this.min) * factor, centre + (this.max - centre) * factor);
  }

  pan(by: number): void {
    this.set(this.min + by, this.max + by);
  }

  /** Moves the window forward when the cursor leaves it. */
  follow(time: number): void {
    if (this.whole || (time >= this.min && time <= this.max)) return;
    const width = this.max - this.min;
    this.set(time - 0.1 * width, time + 0.9 * width);
  }
}
