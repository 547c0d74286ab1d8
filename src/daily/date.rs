//! A day of the Gregorian calendar, in UTC.

use std::fmt;

/// The beginning of the names of daily levels.
const DAILY: &str = "daily-";

/// Whether a level is that of a day, by its folder's name.
pub fn is_daily(level: &str) -> bool {
    level.starts_with(DAILY)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Date {
    /// Since 1970-01-01.
    days: u64,
}

impl Date {
    pub const fn of_days(days: u64) -> Self {
        Self { days }
    }

    /// `seconds` since 1970-01-01, 0 UTC.
    pub fn of_seconds(seconds: f64) -> Self {
        Self { days: (seconds.max(0.0) / 86_400.0) as u64 }
    }

    pub const fn days(self) -> u64 {
        self.days
    }

    /// The folder of its level.
    pub fn level_name(self) -> String {
        format!("{DAILY}{self}")
    }

    /// Year, month and day, after Howard Hinnant, "chrono-Compatible Low-Level Date Algorithms".
    const fn civil(self) -> (u64, u64, u64) {
        // Years begin in March: the leap day is their last one.
        let days = self.days + 719_468;
        let (era, day) = (days / 146_097, days % 146_097);
        let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
        let of_year = day - (365 * year + year / 4 - year / 100);
        let month = (5 * of_year + 2) / 153;
        let of_month = of_year - (153 * month + 2) / 5 + 1;
        let january = (month + 2) % 12 + 1;
        (year + era * 400 + (january <= 2) as u64, january, of_month)
    }
}

impl fmt::Display for Date {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (year, month, day) = self.civil();
        write!(f, "{year:04}-{month:02}-{day:02}")
    }
}

/// `seconds` since 1970-01-01, 0 UTC, to the second: `2026-11-24 15:58:21`.
pub fn time_of(seconds: f64) -> String {
    let of_day = seconds.max(0.0) as u64 % 86_400;
    format!("{} {:02}:{:02}:{:02}", Date::of_seconds(seconds), of_day / 3600, of_day / 60 % 60, of_day % 60)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_are_those_of_the_calendar() {
        for (days, date) in
            [(0, "1970-01-01"), (59, "1970-03-01"), (11_016, "2000-02-29"), (11_017, "2000-03-01"), (20_781, "2026-11-24")]
        {
            assert_eq!(Date::of_days(days).to_string(), date);
        }
        assert_eq!(Date::of_seconds(86_400.0 * 20_781.0 + 86_399.9), Date::of_days(20_781));
        assert_eq!(Date::of_days(20_781).level_name(), "daily-2026-11-24");
    }
}
